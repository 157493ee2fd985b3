// Pairs of directions from text, and values at them as text.

#include <refraster/notes.h>

#include "brdf/evaluation.h"
#include "brdf/points.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace refraster;

namespace {

/// What is said of a text that cannot be read as pairs.
std::string refusal(std::string_view text) {
  try {
    pairs_of(number_table("t.csv", text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a table of numbers has named columns, whatever stands between its cells") {
  for (const char* const text : {"a,b\n1,2\n",
                                 "\xef\xbb\xbf"
                                 "A ,\"B\"\r\n# no\r\n\r\n 1 , \"2\"\r\n",
                                 "a;b\n1;2", "a\tb\n1\t2\n", "a  b\n1   2\n"}) {
    CAPTURE(text);
    const NumberTable table = number_table("t", text);
    CHECK(table.columns == std::vector<std::string>{"a", "b"});
    REQUIRE(table.rows() == 1);
    CHECK(table.at(0, *table.column("b")) == 2);
    CHECK_FALSE(table.column("c"));
  }
  const NumberTable table = number_table("t", "a\nnan\n-inf\n1e999\n-1e-999\n");
  CHECK(std::isnan(table.at(0, 0)));
  CHECK(table.at(1, 0) == -std::numeric_limits<double>::infinity());
  CHECK(table.at(2, 0) == std::numeric_limits<double>::infinity());
  CHECK(table.at(3, 0) == 0);
  CHECK(table.lines == std::vector<int>{2, 3, 4, 5});
}

TEST_CASE("pairs are read from angles of either kind, or from vectors") {
  const auto in_out = pairs_of(number_table("t", "r,theta_in,theta_out,dphi\n0,30,30,180\n"));
  const auto half = pairs_of(number_table("t", "phi_d,theta_h,theta_d\n0,0,30\n"));
  const auto vectors = pairs_of(number_table("t", "in_x,in_y,in_z,out_x,out_y,out_z\n0,0,7,0,3,4\n"));
  CHECK(in_out.at(0).i.x == 0.5);
  CHECK(length(half.at(0).i - in_out.at(0).i) < 1e-15);
  CHECK(vectors.at(0).i == Double3(0, 0, 1));
  CHECK(length(vectors.at(0).o - Double3(0, 0.6, 0.8)) < 1e-15);
  CHECK(in_out_from("30,30,180")->o.x == -0.5);
  CHECK_FALSE(in_out_from("30,30"));
  CHECK_FALSE(in_out_from("30,91,0"));
  CHECK_FALSE(half_difference_from("30,30,inf"));
  CHECK_FALSE(directions_from("0,0,0,0,0,1"));
  CHECK(directions_from("0,0,2,0,0,1")->i.z == 1);
}

TEST_CASE("what is wrong with a table is said, with its line") {
  CHECK(refusal("") == "t.csv: found no line, expected a first line with the names of columns");
  CHECK(refusal("a,a\n") == "t.csv:1: found two columns \"a\", expected each name once");
  CHECK(refusal("theta_in,theta_out,dphi\n1,2\n") == "t.csv:2: found 2 cells, expected 3, as the first line has");
  CHECK(refusal("theta_in,theta_out,dphi\n1,x,3\n") == "t.csv:2: theta_out: found \"x\", expected a number");
  CHECK(refusal("theta_in,theta_out,dphi\n1,,3\n") == "t.csv:2: theta_out: found nothing, expected a number");
  CHECK(refusal("theta_in,theta_out,dphi\n0,0,0\n-1,100,3\n") ==
        "t.csv:3: theta_in,theta_out,dphi: found -1,100,3, expected thetas from 0 to 90 degrees, and a finite dphi");
  CHECK(refusal("a,b\n1,2\n").starts_with("t.csv: found the columns \"a,b\", expected among them theta_in,"));
  CHECK(refusal(std::string_view("a\0b\n", 4)) == "t.csv: found a binary file, expected a table of numbers as text");
}

TEST_CASE("values are written so that they can be read again") {
  const Brdf lambert("lambert", {Lambert{Double3(0.5)}});
  const std::vector<DirectionPair> pairs = {directions_of(InOutAngles{30, 40, 50}),
                                            directions_of(InOutAngles{0, 90, 0})};
  const NumberTable back = number_table("t", evaluation_csv(lambert, pairs));
  CHECK(back.rows() == 2);
  CHECK(length(pairs_of(back).at(0).o - pairs[0].o) < 1e-15);
  const auto rgb = rgb_columns(back);
  CHECK(back.at(0, rgb[0]) == model_value(Lambert{Double3(0.5)}, pairs[0]).x);
  CHECK(evaluation_json(lambert, pairs).find("\"theta_in\": ") != std::string::npos);
  CHECK_THROWS_AS(rgb_columns(number_table("t", "r,g\n")), InputError);
}
