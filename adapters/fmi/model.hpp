// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fmi/setting.hpp"

namespace odeum::adapters::fmi {

class Inputs;
using Values = std::map<std::string, std::string>;

/// Whether the model is integrated by others, or integrates itself from one communication point to
/// the next (co-simulation).
enum class Purpose { model_exchange, co_simulation };

/// A shared object of an FMU, never unloaded.
class Binary {
 public:
  /// Throws LoadError where there is none for this machine or it cannot be loaded.
  Binary(Purpose purpose, const Description& description, const std::filesystem::path& folder);

  void* found(const std::string& name) const;  ///< null: it exports no such function
  /// Throws LoadError where it exports no such function.
  template <class Function>
  Function function(const std::string& name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const std::string& name) const;
  void* handle_ = nullptr;
};

/// What a model says when its discrete states have been computed anew.
struct EventInfo {
  bool more = false, terminate = false;
  bool states = false;  ///< the values of continuous states have changed
  bool has_next = false;
  double next = 0;  ///< the time of its next time event
};

/// An instance of a model. Functions that return a number return 0 on success.
class Model {
 public:
  virtual ~Model();
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// The state at the start. A model without continuous states has its outputs for one, of which
  /// all are held from event to event but those that `observe` reads.
  std::vector<double> y0;
  std::size_t indicators = 0;  ///< of events
  EventInfo start;             ///< at the end of the initialisation
  bool asks_at_start = false;  ///< for an event, at the end of a step
  bool has_states = false, has_jacobian = false;

  int rhs(double t, const double* y, double* dydt);
  /// Row-major; only where has_jacobian.
  int jacobian(double t, const double* y, double* j);
  int indicate(double t, const double* y, double* values);
  /// Gives y the outputs of a model without states.
  int observe(double t, double* y);

  /// Event mode at t: y becomes the state after it. Inputs that jump at `jump` have the values from
  /// then on. Throws LoadError where a function fails.
  EventInfo happen(double t, double* y, double jump);
  /// In co-simulation: integrates from t to t + h, where y becomes the state. Inputs have the
  /// values of t in between. Throws LoadError where that fails, or the model ends its simulation.
  void step(double t, double h, double* y);

  /// At the end of an accepted step: whether the model asks for an event, or for the end. Throws
  /// LoadError likewise.
  bool completes(double t, const double* y);

 protected:
  /// `inputs` has to outlive this; null: they are held.
  Model(std::string prefix, const Description& d, const Binary& binary, const Inputs* inputs)
      : prefix_(std::move(prefix)), description_(d), binary_(binary), inputs_(inputs) {}
  /// From the initialisation to continuous-time mode, with these values; in co-simulation to its
  /// first step. Throws LoadError.
  void initialise(Purpose purpose, const Values& values);

  static int wrong(int status) { return status > 1 ? status : 0; }
  /// Calls a function that has no arguments but the instance.
  void call(const char* name);
  virtual void set(const Setting& setting) = 0;  ///< throws LoadError
  virtual int put(const Variable& variable, double value) = 0;
  virtual double get(const Variable& variable) = 0;  ///< throws LoadError
  virtual void enter_initialisation() = 0;
  virtual std::size_t count_states() = 0;
  virtual std::size_t count_indicators() = 0;
  virtual int set_time(double t) = 0;
  virtual int set_states(const double* y) = 0;
  virtual int get_states(double* y) = 0;
  virtual int derivatives(double* dydt) = 0;
  virtual int get_indicators(double* values) = 0;
  /// Column k of the Jacobian.
  virtual int column(std::size_t k, double* out) = 0;
  virtual int update_discrete_states(EventInfo& info) = 0;
  virtual int complete_step(bool& event, bool& terminate) = 0;
  /// False: the model is to end.
  virtual bool do_step(double t, double h) = 0;

  const std::string prefix_;  ///< of the names of functions
  const Description& description_;
  const Binary binary_;
  void* self_ = nullptr;

 private:
  int place(double t, const double* y);
  void read(const std::vector<std::size_t>& variables, double* y);
  void begin_steps();
  EventInfo update();
  bool step_asks();
  void set_inputs(double t);

  const Inputs* inputs_;
  double event_ =
      -std::numeric_limits<double>::infinity();  ///< the time of the last event, or the start
  double passed_ = event_;  ///< the last time at which inputs jump whose later values hold
};

/// Loads and initialises a model with these values of its variables. Throws LoadError, without a
/// file name, where it fails, or a value cannot be set.
std::unique_ptr<Model> make_model(Purpose purpose, const Description& description,
                                  const std::filesystem::path& folder, const Values& values,
                                  const Inputs* inputs);
std::unique_ptr<Model> make_model2(Purpose purpose, const Description& description,
                                   const Binary& binary, const std::filesystem::path& folder,
                                   const Values& values, const Inputs* inputs);
std::unique_ptr<Model> make_model3(Purpose purpose, const Description& description,
                                   const Binary& binary, const std::filesystem::path& folder,
                                   const Values& values, const Inputs* inputs);

std::vector<Setting> settings_of(const Description& description, const Values& values);

/// The last message of a model, for people.
std::string& last_message();
/// Throws LoadError where a call returned an error.
void require(int status, const std::string& function);

}  // namespace odeum::adapters::fmi
