// A Modbus server link with a plant that a test cycles step by step, and a client of raw bytes.
#pragma once

#include <atomic>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/raw_client.hpp"
#include "symplant/link/link.hpp"
#include "unit/exec/cell.hpp"

namespace symplant::test {

inline std::unique_ptr<link::Link> open_or_throw(const std::string& url, const tables::PlantTables& tables,
                                                 const link::LinkSettings& settings = {}) {
  auto result = link::open_link({url, 0, settings}, tables);
  if (auto* error = std::get_if<link::LinkError>(&result)) throw std::runtime_error(error->message);
  return std::move(std::get<std::unique_ptr<link::Link>>(result));
}

inline std::uint16_t port_of(const link::Link& link) {
  const std::string url = link.url();
  return static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
}

/// The paper's cell, served. The test sets plant time.
class CellServer {
 public:
  CellServer()
      : tables_(cell_tables()), plant_(tables_), link_(open_or_throw("modbus-tcp-server://127.0.0.1:0", tables_)) {
    plant_->advance_to(0);
    link_->write_events(*plant_, {});
    plant_->forget_changed_events();
  }
  ~CellServer() { stop_cycling(); }
  CellServer(const CellServer&) = delete;
  CellServer& operator=(const CellServer&) = delete;

  void cycle(tables::Time duration) {
    link_->read_operations(*plant_, 0);
    plant_->advance_to(plant_->now() + duration);
    link_->write_events(*plant_, {});
    plant_->forget_changed_events();
  }

  /// Cycles as fast as possible in a separate thread; plant time runs much faster than real time.
  void start_cycling() {
    cycling_ = std::thread([this] {
      while (!stop_) {
        cycle(tables::kMillisecond);
        std::this_thread::yield();
      }
    });
  }
  void stop_cycling() {
    stop_ = true;
    if (cycling_.joinable()) cycling_.join();
  }

  plant::Plant& plant() { return *plant_; }
  link::Link& link() { return *link_; }
  std::uint16_t port() const { return port_of(*link_); }

 private:
  tables::PlantTables tables_;
  OwnedPlant plant_;
  std::unique_ptr<link::Link> link_;
  std::atomic<bool> stop_{false};
  std::thread cycling_;
};

}  // namespace symplant::test
