// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fmi/description.hpp"

namespace odeum::adapters::fmi {

using Values = std::map<std::string, std::string>;

/// A shared object of an FMU, never unloaded.
class Binary {
 public:
  /// Throws LoadError where there is none for this machine or it cannot be loaded.
  Binary(const Description& description, const std::filesystem::path& folder);

  /// Throws LoadError where it exports no such function.
  template <class Function>
  Function function(const std::string& name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const std::string& name) const;
  void* handle_ = nullptr;
};

/// An instance of a model in continuous-time mode, never freed. The functions return 0 on success.
class Model {
 public:
  virtual ~Model() = default;
  Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  std::vector<double> y0;

  int rhs(double t, const double* y, double* dydt) { return place(t, y) || derivatives(dydt); }
  /// Row-major; only where has_jacobian().
  int jacobian(double t, const double* y, double* j);
  bool has_jacobian() const { return has_jacobian_; }

 protected:
  virtual int place(double t, const double* y) = 0;
  virtual int derivatives(double* dydt) = 0;
  /// Column k of the Jacobian.
  virtual int column(std::size_t k, double* out) = 0;
  bool has_jacobian_ = false;
};

/// Loads and initialises a model with these values of its variables. Throws LoadError, without a
/// file name, where it has events, fails, or a value cannot be set.
std::unique_ptr<Model> make_model(const Description& description,
                                  const std::filesystem::path& folder, const Values& values);
std::unique_ptr<Model> make_model2(const Description& description, const Binary& binary,
                                   const std::filesystem::path& folder, const Values& values);
std::unique_ptr<Model> make_model3(const Description& description, const Binary& binary,
                                   const std::filesystem::path& folder, const Values& values);

/// A value of --set with the variable that it is for. Throws LoadError where there is no such
/// variable, or none that can be set, or the text is not a number of its type.
struct Setting {
  const Variable* variable;
  std::string text;
  double real() const;
  long long integer(long long least, long long most) const;
  bool boolean() const;
};
std::vector<Setting> settings_of(const Description& description, const Values& values);

/// The last message of a model, for people.
std::string& last_message();
/// Throws LoadError where a call returned an error.
void require(int status, const char* function);
/// What the model says of events after its initialisation. Throws LoadError where there are any.
void refuse_events(bool next_event_time, double when, bool terminate, bool at_steps);

}  // namespace odeum::adapters::fmi
