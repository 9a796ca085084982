// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "odeum/input/yaml_tree.hpp"
#include "sbml/module.hpp"
#include "sbml/translation.hpp"

namespace odeum {
namespace adapters::sbml {
namespace {

/// Throws for a text that may have entities, before a library reads it: SBML has none.
void require_plain(const std::string& file, const std::string& xml) {
  const auto fail = [&](std::size_t at, const std::string& what) {
    const auto line = static_cast<std::size_t>(
        std::count(xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    throw InputError(file, {line + 1, 1}, what);
  };
  if (const std::size_t zero = xml.find('\0'); zero != std::string::npos)
    fail(zero, "not UTF-8; got a zero byte, expected the text of an SBML model");
  for (const char* const word : {"<!DOCTYPE", "<!ENTITY"})
    if (const std::size_t at = xml.find(word); at != std::string::npos)
      fail(at, fmt::format("a declaration of entities; got {}, expected none: SBML has no entities",
                           word));
}

/// Throws for the first error that libsbml finds.
void require_valid(const std::string& file, const SBMLDocument& document) {
  for (unsigned k = 0; k < document.getNumErrors(); ++k) {
    const SBMLError& error = *document.getError(k);
    if (error.getSeverity() < LIBSBML_SEV_ERROR) continue;
    std::string what = error.getMessage();
    what = what.substr(0, what.find('\n'));
    throw InputError(file, {std::max(1U, error.getLine()), std::max(1U, error.getColumn())},
                     fmt::format("not valid SBML: {} (rule {} of SBML: {})",
                                 error.getShortMessage(), error.getErrorId(), shown(what)));
  }
}

void require_core(const std::string& file, SBMLDocument& document) {
  if (document.getLevel() < 2)
    throw InputError(file, {}, "SBML level 1; got it, expected level 2 or 3");
  const XMLNamespaces* const spaces = document.getNamespaces();
  for (int k = 0; spaces && k < spaces->getNumNamespaces(); ++k) {
    const std::string uri = spaces->getURI(k), prefix = spaces->getPrefix(k);
    if (uri.find("sbml.org/sbml/level3") == std::string::npos || prefix.empty() ||
        uri.find("/core") != std::string::npos)
      continue;
    if (document.isSetPkgRequired(prefix) ? document.getPkgRequired(prefix)
                                          : document.getPackageRequired(prefix))
      throw InputError(
          file, {},
          fmt::format("the package {} of SBML is not supported; got a model that needs "
                      "it, expected one of SBML core",
                      prefix));
  }
}

/// The places at which units that are given disagree, as libsbml finds them: a sentence for all, as
/// it is a fault of the text and not of its numbers. Nothing of units that are not given.
std::string warning_of_units(const std::string& file, SBMLDocument& document) {
  document.getErrorLog()->clearLog();
  document.setConsistencyChecks(LIBSBML_CAT_UNITS_CONSISTENCY, true);
  for (const auto category : {LIBSBML_CAT_GENERAL_CONSISTENCY, LIBSBML_CAT_IDENTIFIER_CONSISTENCY,
                              LIBSBML_CAT_MATHML_CONSISTENCY, LIBSBML_CAT_SBO_CONSISTENCY,
                              LIBSBML_CAT_OVERDETERMINED_MODEL, LIBSBML_CAT_MODELING_PRACTICE})
    document.setConsistencyChecks(category, false);
  document.checkConsistency();
  unsigned count = 0;
  std::string first;
  for (unsigned k = 0; k < document.getNumErrors(); ++k) {
    const SBMLError& error = *document.getError(k);
    constexpr unsigned units_of_formulas = 105;  // the hundred of their rules in SBML
    if (error.getErrorId() / 100 != units_of_formulas || error.getSeverity() < LIBSBML_SEV_WARNING)
      continue;
    if (count++ > 0) continue;
    first = fmt::format("{}:{}: {}", file, std::max(1U, error.getLine()), error.getShortMessage());
  }
  if (count == 0) return {};
  return fmt::format(
      "{}{}; numbers are taken as they stand", first,
      count > 1 ? fmt::format(", as at {} other place{}", count - 1, count > 2 ? "s" : "") : "");
}

cases::SbmlText translated(const std::string& file, const std::string& xml, double end) {
  require_plain(file, xml);
  const std::unique_ptr<SBMLDocument> document(readSBMLFromString(xml.c_str()));
  require_valid(file, *document);
  const Model* const model = document->getModel();
  if (!model) throw InputError(file, {}, "no model; got none, expected one in <sbml>");
  require_core(file, *document);
  cases::SbmlText result;
  try {
    result.text = Translation(*model).text(end);
  } catch (const ElementError& error) {
    throw InputError(file, {std::max(1U, error.line()), std::max(1U, error.column())},
                     fmt::format("not supported: {}", error.what()));
  } catch (const Unsupported& error) {
    throw InputError(file, {}, fmt::format("not supported: {}", error.what()));
  }
  if (model->getNumConstraints() > 0)
    result.warnings.push_back(fmt::format("{}: constraints are not watched", file));
  if (std::string units = warning_of_units(file, *document); !units.empty())
    result.warnings.push_back(std::move(units));
  return result;
}

}  // namespace
}  // namespace adapters::sbml
}  // namespace odeum

void odeum_sbml_text(const std::string& file, const std::string& xml, double end,
                     odeum::cases::SbmlText& result, std::string& fault) {
  try {
    result = odeum::adapters::sbml::translated(file, xml, end);
  } catch (const odeum::InputError& error) {
    fault = error.what();
  } catch (const std::exception& error) {
    fault = fmt::format("{}: {}", file, error.what());
  }
}

void odeum_sbml_support(std::string& words) {
  words = fmt::format("levels 2 and 3, by libsbml {}", getLibSBMLDottedVersion());
}
