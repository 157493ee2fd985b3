#pragma once
// Warnings about the objects of a scene, each said once.

#include <string>
#include <vector>

namespace refraster {

class WarningList {
public:
  /// What is said of several objects is said once, with their names.
  void add(const std::string& object, const std::string& text);
  /// Of no object.
  void add(const std::string& text) { add({}, text); }

  /// In the order in which they were first added: "ball: …", "ball, knot: …", "ball and 7 more: …".
  std::vector<std::string> lines() const;

private:
  struct Warning {
    std::string text;
    std::vector<std::string> objects;
  };
  std::vector<Warning> warnings_;
};

} // namespace refraster
