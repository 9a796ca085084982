// SPDX-License-Identifier: BSD-3-Clause
// A model in SBML becomes a text, or is refused by the name of what is not supported.
#include <gtest/gtest.h>

#include "odeum/cases/kinds/sbml/sbml.hpp"
#include "odeum/formula/problem.hpp"

namespace odeum::sbml_test {
namespace {

std::string model(const std::string& parts, const std::string& more = "") {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<sbml xmlns="http://www.sbml.org/sbml/level3/version2/core" level="3" version="2")" +
         more + R"(><model id="m">)" + parts + "</model></sbml>\n";
}

std::string math(const std::string& text) {
  return R"(<math xmlns="http://www.w3.org/1998/Math/MathML">)" + text + "</math>";
}

const std::string cell =
    R"(<listOfCompartments><compartment id="cell" size="2" constant="true"/></listOfCompartments>)";
const std::string species = R"(<listOfSpecies>
<species id="A" compartment="cell" initialAmount="6" hasOnlySubstanceUnits="false"
 boundaryCondition="false" constant="false"/>
<species id="t" compartment="cell" initialConcentration="1" hasOnlySubstanceUnits="true"
 boundaryCondition="false" constant="false"/></listOfSpecies>)";
const std::string reaction = R"(<listOfReactions><reaction id="J" reversible="false">
<listOfReactants><speciesReference species="A" stoichiometry="2" constant="true"/></listOfReactants>
<listOfProducts><speciesReference species="t" stoichiometry="1" constant="true"/></listOfProducts>
<kineticLaw>)" + math("<apply><times/><ci>k</ci><ci>A</ci></apply>") +
                             R"(<listOfLocalParameters><localParameter id="k" value="0.5"/>
</listOfLocalParameters></kineticLaw></reaction></listOfReactions>)";

formula::Problem problem(const std::string& xml) {
  return formula::read_problem("text", cases::text_of_sbml("m.xml", xml, 5).text);
}

std::string fault(const std::string& xml) {
  try {
    problem(xml);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

void expect_fault(const std::string& xml, const std::string& part) {
  const std::string got = fault(xml);
  EXPECT_TRUE(got.starts_with("m.xml:") && got.find(part) != std::string::npos)
      << "got       " << got << "\nexpected  " << part;
}

double output(const formula::Problem& p, const std::string& name, const std::vector<double>& y) {
  for (const formula::Output& each : p.outputs)
    if (each.name == name) {
      double value = 0;
      formula::Evaluator<double>(p.graph, {each.value})(0, y.data(), &value);
      return value;
    }
  ADD_FAILURE() << name;
  return 0;
}

// A model of a benchmark collection, as COPASI writes it.
TEST(Sbml, APieceWithTheOppositeConditionIsTheOtherwise) {
  const auto rule = [](const std::string& last) {
    return cell + species + reaction +
           R"(<listOfParameters><parameter id="x" constant="false"/></listOfParameters>
<listOfRules><assignmentRule variable="x">)" +
           math(
               "<piecewise><piece><cn>1</cn><apply><gt/><ci>A</ci><cn>2</cn></apply></piece>"
               "<piece><cn>3</cn><apply>" +
               last + "</apply></piece></piecewise>") +
           "</assignmentRule></listOfRules>";
  };
  const formula::Problem p = problem(model(rule("<leq/><ci>A</ci><cn>2</cn>")));
  EXPECT_DOUBLE_EQ(output(p, "x", {3, 2}), 1);
  EXPECT_DOUBLE_EQ(output(p, "x", {2, 2}), 3);
  expect_fault(model(rule("<lt/><ci>A</ci><cn>2</cn>")), "a piecewise without an otherwise");
}

TEST(Sbml, AmountsAndConcentrationsOfAReaction) {
  const formula::Problem p = problem(model(cell + species + reaction));
  // A taken word gives way as a name, and stays one of a column.
  EXPECT_EQ(p.states, (std::vector<std::string>{"A", "t_"}));
  EXPECT_EQ(p.y0, (std::vector<long double>{3, 2}));
  const std::vector<double> y{3, 2};
  double f[2];
  formula::Evaluator<double>(p.graph, p.equations)(0, y.data(), f);
  EXPECT_DOUBLE_EQ(f[0], -2 * 1.5 / 2);
  EXPECT_DOUBLE_EQ(f[1], 1.5);
  EXPECT_DOUBLE_EQ(output(p, "A_amount", y), 6);
  EXPECT_DOUBLE_EQ(output(p, "t", y), 2);
  EXPECT_DOUBLE_EQ(output(p, "t_concentration", y), 1);
  EXPECT_DOUBLE_EQ(output(p, "J", y), 1.5);
  EXPECT_EQ(p.parameters.at("J_k"), 0.5L);
}

TEST(Sbml, ARateOfAVolumeThatGrows) {
  // The amount of A stays, so that its concentration falls by the rate of the volume.
  const formula::Problem p = problem(model(
      R"(<listOfCompartments><compartment id="cell" size="2" constant="false"/></listOfCompartments>)" +
      species +
      R"(<listOfParameters><parameter id="x" constant="false" value="0"/></listOfParameters>
<listOfRules><rateRule variable="cell">)" +
      math("<cn>0.5</cn>") + R"(</rateRule><rateRule variable="x">)" +
      math(
          R"(<apply><csymbol encoding="text" definitionURL="http://www.sbml.org/sbml/symbols/rateOf">
rateOf</csymbol><ci>A</ci></apply>)") +
      "</rateRule></listOfRules>"));
  ASSERT_EQ(p.states, (std::vector<std::string>{"cell", "x"}));
  const std::vector<double> y{4, 0};
  double f[2];
  formula::Evaluator<double>(p.graph, p.equations)(0, y.data(), f);
  EXPECT_DOUBLE_EQ(f[0], 0.5);
  EXPECT_DOUBLE_EQ(f[1], -6. / 4 * 0.5 / 4);
  EXPECT_DOUBLE_EQ(output(p, "A", y), 1.5);
}

TEST(Sbml, EntitiesAreNeverRead) {
  const std::string bomb = R"(<?xml version="1.0"?><!DOCTYPE s [<!ENTITY a "aaaaaaaaaa">
<!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;">]><sbml>&c;</sbml>)";
  expect_fault(bomb, "m.xml:1:1: a declaration of entities; got <!DOCTYPE");
  expect_fault("<!DOCTYPE s SYSTEM \"file:///etc/passwd\"><sbml/>", "a declaration of entities");
  expect_fault(std::string("<\0s\0b\0m\0l\0", 10), "not UTF-8");
}

TEST(Sbml, WhatIsNotSupportedIsNamed) {
  expect_fault("no xml", "not valid SBML");
  expect_fault("<a/>", "not valid SBML");
  expect_fault(model(cell + species + reaction).substr(0, 500), "not valid SBML");
  expect_fault(R"(<sbml xmlns="http://www.sbml.org/sbml/level1" level="1" version="2"/>)", "SBML");
  const std::string k =
      R"(<listOfParameters><parameter id="k" constant="false" value="1"/></listOfParameters>)";
  const auto ruled = [&](const std::string& rule) {
    return model(k + "<listOfRules>" + rule + "</listOfRules>");
  };
  expect_fault(ruled("<algebraicRule>" + math("<ci>k</ci>") + "</algebraicRule>"),
               "not supported: algebraic rules");
  expect_fault(ruled(R"(<rateRule variable="k">)" + math(R"(<apply><csymbol encoding="text"
definitionURL="http://www.sbml.org/sbml/symbols/delay">delay</csymbol><ci>k</ci><cn>1</cn></apply>)") +
                     "</rateRule>"),
               "not supported: a delay (for k)");
  expect_fault(ruled(R"(<assignmentRule variable="k">)" +
                     math("<apply><plus/><ci>k</ci><cn>1</cn></apply>") + "</assignmentRule>"),
               "a cycle of rules");
  expect_fault(ruled(R"(<rateRule variable="k">)" + math("<ci>q</ci>") + "</rateRule>"),
               "the name q, which the model does not declare");
  expect_fault(model(R"(<listOfParameters><parameter id="k" constant="true"/></listOfParameters>)"),
               "a quantity without a value (k)");
  expect_fault(model(k, R"( xmlns:comp="http://www.sbml.org/sbml/level3/version1/comp/version1"
 comp:required="true")"),
               "the package comp of SBML is not supported");
}

TEST(Sbml, AnEventBecomesOneOfTheText) {
  const formula::Problem p = problem(model(
      R"(<listOfCompartments><compartment id="cell" size="2" constant="false"/></listOfCompartments>)" +
      species + reaction + R"(<listOfEvents>
<event id="nothing" useValuesFromTriggerTime="true"><trigger initialValue="true" persistent="true">)" +
      math("<apply><gt/><ci>A</ci><cn>2</cn></apply>") + R"(</trigger></event>
<event id="grow" useValuesFromTriggerTime="false"><trigger initialValue="false" persistent="false">)" +
      math("<apply><lt/><ci>A</ci><cn>2</cn></apply>") + "</trigger><priority>" +
      math("<ci>t</ci>") + "</priority><delay>" + math("<cn>0.5</cn>") + R"(</delay>
<listOfEventAssignments><eventAssignment variable="cell">)" +
      math("<cn>4</cn>") + R"(</eventAssignment><eventAssignment variable="A">)" +
      math("<apply><plus/><ci>A</ci><cn>1</cn></apply>") +
      "</eventAssignment></listOfEventAssignments></event></listOfEvents>"));
  ASSERT_EQ(p.events.size(), 1U);  // the other sets nothing
  const formula::Event& event = p.events[0];
  EXPECT_EQ(event.name, "grow");
  EXPECT_FALSE(event.initially || event.persistent || event.early);
  EXPECT_TRUE(event.priority != formula::no_node && event.delay != formula::no_node);
  // The amount of A is its concentration after the event times the volume before it.
  std::vector<double> y(p.y0.begin(), p.y0.end());
  for (const auto& [state, id] : event.set) {
    double value = 0;
    formula::Evaluator<double>(p.graph, {id})(0, y.data(), &value);
    EXPECT_EQ(value, p.states[state] == "cell" ? 4 : (3 + 1) * 2) << p.states[state];
  }
  EXPECT_EQ(event.set.size(), 2U);
}

/// The warnings of a model of x' = k, whose k has these units.
std::vector<std::string> warnings(const std::string& units) {
  const std::string xml =
      R"(<?xml version="1.0" encoding="UTF-8"?>
<sbml xmlns="http://www.sbml.org/sbml/level3/version1/core" level="3" version="1">
<model id="m" timeUnits="second"><listOfUnitDefinitions><unitDefinition id="rate"><listOfUnits>
<unit kind="mole" exponent="1" scale="0" multiplier="1"/>
<unit kind="second" exponent="-1" scale="0" multiplier="1"/></listOfUnits></unitDefinition>
</listOfUnitDefinitions><listOfParameters>
<parameter id="x" value="1" units="mole" constant="false"/>
<parameter id="k" value="2" constant="true")" +
      units + R"(/></listOfParameters><listOfRules><rateRule variable="x">)" + math("<ci>k</ci>") +
      "</rateRule></listOfRules></model></sbml>\n";
  return cases::text_of_sbml("m.xml", xml, 5).warnings;
}

TEST(Sbml, UnitsAreCheckedWhereTheyAreGiven) {
  EXPECT_TRUE(warnings("").empty());
  EXPECT_TRUE(warnings(R"( units="rate")").empty());
  const std::vector<std::string> said = warnings(R"( units="metre")");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(said[0].starts_with("m.xml:")) << said[0];
  EXPECT_NE(said[0].find("nits"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("; numbers are taken as they stand"), std::string::npos) << said[0];
}

}  // namespace
}  // namespace odeum::sbml_test
