// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorLog.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <cstdlib>
#include <iostream>
#include <utility>

namespace
{

/// VTK's text is "ERROR: In <file>, line <n>\n<class> (<address>): <message>\n\n".
std::string GetMessage(const char* text)
{
  std::string message = text ? text : "";
  const std::size_t colon = message.find("): ");
  if (colon != std::string::npos)
  {
    message.erase(0, colon + 3);
  }
  const std::size_t end = message.find_last_not_of(" \n");
  message.erase(end == std::string::npos ? 0 : end + 1);
  return message.empty() ? "unknown error" : message;
}

} // namespace

vtkStandardNewMacro(ErrorLog);

void ErrorLog::Install()
{
  vtkNew<ErrorLog> log;
  vtkOutputWindow::SetInstance(log);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

std::string ErrorLog::TakeFirstError()
{
  auto* log = ErrorLog::SafeDownCast(vtkOutputWindow::GetInstance());
  return log ? std::exchange(log->FirstError, {}) : std::string();
}

std::string ErrorLog::TakeFirstWarning()
{
  auto* log = ErrorLog::SafeDownCast(vtkOutputWindow::GetInstance());
  return log ? std::exchange(log->FirstWarning, {}) : std::string();
}

void ErrorLog::DisplayErrorText(const char* text)
{
  const std::string message = GetMessage(text);
  if (message.find("bad X server connection") != std::string::npos)
  {
    // VTK ends the program after this one, so it cannot wait.
    std::cerr << "error: there is no display; DISPLAY=:1 or xvfb-run may help\n";
    std::exit(EXIT_FAILURE);
  }
  if (this->FirstError.empty())
  {
    this->FirstError = message;
  }
}

void ErrorLog::DisplayWarningText(const char* text)
{
  if (this->FirstWarning.empty())
  {
    this->FirstWarning = GetMessage(text);
  }
}
