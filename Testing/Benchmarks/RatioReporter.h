// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RatioReporter_h
#define RatioReporter_h

/// \file
/// What the benchmark programs share: tables of rates with ratios to a peer, and peak memory.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace bravais
{

/// Prints one line a benchmark: million items a second, and the ratio to each of the peers.
class RatioReporter : public benchmark::BenchmarkReporter
{
public:
  RatioReporter(std::string unit, std::vector<std::string> peers)
    : Unit(std::move(unit))
    , Peers(std::move(peers))
  {
  }

  bool ReportContext(const Context&) override { return true; }

  /// Of repetitions the fastest counts: others share the machine.
  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      const auto items = run.counters.find("items_per_second");
      if (run.run_type == Run::RT_Iteration && items != run.counters.end())
      {
        const std::string name = run.run_name.function_name;
        if (!this->Rates.count(name))
        {
          this->Names.push_back(name);
        }
        double& rate = this->Rates[name];
        rate = rate > items->second.value ? rate : items->second.value;
      }
    }
  }

  void Finalize() override
  {
    std::printf("%-44s %14s", "", this->Unit.c_str());
    for (const std::string& peer : this->Peers)
    {
      std::printf("  / %s", peer.c_str());
    }
    std::printf("\n");
    for (const std::string& name : this->Names)
    {
      std::printf("%-44s %14.1f", name.c_str(), this->Rates[name] * 1e-6);
      for (const std::string& peer : this->Peers)
      {
        std::printf("  %*.2f", static_cast<int>(peer.size()) + 2,
          this->Rates[peer] > 0.0 ? this->Rates[name] / this->Rates[peer] : 0.0);
      }
      std::printf("\n");
    }
  }

private:
  std::string Unit;
  std::vector<std::string> Peers;
  std::vector<std::string> Names;
  std::map<std::string, double> Rates;
};

/// Registers work on a number of items, for real time, the fastest of three repetitions.
inline void AddBenchmark(const std::string& name, double items, const std::function<void()>& work)
{
  benchmark::RegisterBenchmark(name.c_str(),
    [=](benchmark::State& state)
    {
      for (auto _ : state)
      {
        work();
      }
      state.SetItemsProcessed(static_cast<std::int64_t>(items * state.iterations()));
    })
    ->UseRealTime()
    ->MinTime(0.3)
    ->Repetitions(3);
}

/// A line of /proc/self/status, in MiB; 0 where there is none.
inline double GetProcessMemory(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kilobytes = 0.0;
    if (word == key && status >> kilobytes)
    {
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}

/// By how many MiB the resident memory grew, at its peak, while `work` ran.
inline double MeasurePeakMemory(const std::function<void()>& work)
{
  std::ofstream("/proc/self/clear_refs") << 5; // makes VmHWM start anew
  const double before = GetProcessMemory("VmRSS:");
  work();
  return GetProcessMemory("VmHWM:") - before;
}

} // namespace bravais

#endif
