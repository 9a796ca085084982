// SPDX-License-Identifier: BSD-3-Clause
// Events of a text that are refused, each with its place.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "odeum/formula/problem.hpp"

namespace odeum::tests::event_reader_test {
namespace {

TEST(EventReader, ThoseThatAreNotSoundAreRefusedWithTheirPlace) {
  const std::pair<const char*, const char*> bad[] = {
      {"- {when: x, falling: true}", "6:5: events[1]: got one that sets nothing and does not stop"},
      {"- {when: x, set: {z: 1}}", "6:21: events[1]: set: no state; got z"},
      {"- {set: {x: 1}}", "6:5: events[1]: got neither when nor at"},
      {"- {when: x, at: 1, set: {x: 1}}", "6:5: events[1]: got both when and at"},
      {"- {at: 1, set: {x: 1}}\n  - {at: 1, set: {x: 2}}",
       "7:5: events[2]: two events set x at one time"},
      {"- {when: x, set: {x: 1}}\n  - {when: x, rising: true, set: {x: 2}}",
       "7:5: events[2]: two events set x at one time"},
      {"- {at: 1, every: 0, set: {x: 1}}", "6:20: events[1]: every: got 0"},
      {"- {at: 1, until: 2, set: {x: 1}}", "6:13: events[1]: until: got one without `every`"},
      {"- {at: -1, set: {x: 1}}", "6:10: events[1]: at: before the start"},
      {"- {when: x, every: 1, set: {x: 1}}", "6:15: events[1]: every: got one beside `when`"},
      {"- {when: 1 + 1, set: {x: 1}}", "6:12: events[1]: when: got a constant"},
      {"- {when: log(x - 5), set: {x: 1}}", "6:12: events[1]: when: not finite at the start"},
      {"- {when: x, rising: yes, set: {x: 1}}", "6:23: events[1]: rising: got yes"},
      {"- {when: x, set: {x: q}}", "6:24: events[1]: set: x: unknown name; got q"},
      {"- {when: x, sat: {x: 1}}", "6:15: events[1].sat: an unknown key"},
      {"- {when: x, set: {x: 1}}\nexact: {x: exp(-t)}", "7:1: exact: got this beside events"},
      {"- {when: x, order: 1.5, set: {x: 1}}", "6:22: events[1]: order: got 1.5"},
      {"- {when: x > 1, rising: true, set: {x: 1}}", "6:19: events[1]: rising: got one beside a c"},
      {"- {when: x, initially: false, set: {x: 1}}", "6:15: events[1]: initially: got one beside"},
      {"- {when: 2 > 1, set: {x: 1}}", "6:12: events[1]: when: got a constant"},
      {"- {at: 1, delay: 0 - 1, set: {x: 1}}", "6:20: events[1]: delay: got -1"},
      {"- {at: 1, early: 1, set: {x: 1}}", "6:20: events[1]: early: got 1"},
      {"- {when: log(x - 5) > 1, set: {x: 1}}", "6:3: events: a comparison of a condition is not"}};
  for (const auto& [event, message] : bad) {
    const std::string text = fmt::format(
        "# events\nstates: {{x: 1}}\nequations: {{x: -x}}\ntime: {{end: 3}}\nevents:\n  {}\n",
        event);
    try {
      formula::read_problem("f.yaml", text);
      ADD_FAILURE() << event;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(fmt::format("f.yaml:{}", message), 0), 0U)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace odeum::tests::event_reader_test
