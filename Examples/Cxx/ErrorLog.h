// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ErrorLog_h
#define ErrorLog_h

/// \file
/// Keeps what VTK reports off the screen, so that a program can say one clear sentence instead.

#include "vtkOutputWindow.h"

#include <string>

class ErrorLog : public vtkOutputWindow
{
public:
  static ErrorLog* New();
  vtkTypeMacro(ErrorLog, vtkOutputWindow);

  /// Takes all messages from now on.
  static void Install();

  /// The first error since the last call, without its place in VTK's sources; empty if there was
  /// none.
  static std::string TakeFirstError();

  /// The same of warnings.
  static std::string TakeFirstWarning();

  void DisplayErrorText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayWarningText(const char* text) override;
  void DisplayText(const char*) override {}

protected:
  ErrorLog() = default;
  ~ErrorLog() override = default;

private:
  ErrorLog(const ErrorLog&) = delete;
  void operator=(const ErrorLog&) = delete;

  std::string FirstError;
  std::string FirstWarning;
};

#endif
