#include "cli/record/topic_choice.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace farrier::cli {

std::vector<std::string> topic_names() {
  std::vector<std::string> names;
  for (const bus::TopicSpec& topic : bus::topics()) {
    names.emplace_back(topic.name);
  }
  return names;
}

void declare_topic_choice(CLI::App& app, std::vector<std::string>& names) {
  app.add_option("--topics", names, "topics of idl/README.md; all unless told")
      ->delimiter(',')
      ->check(CLI::IsMember(topic_names()))
      ->type_name("<topic>,...");
}

std::vector<bus::TopicId> topics_of(const std::vector<std::string>& names) {
  std::vector<bus::TopicId> topics;
  for (const bus::TopicSpec& topic : bus::topics()) {
    if (std::ranges::find(names, topic.name) != names.end()) {
      topics.push_back(topic.id);
    }
  }
  return topics;
}

}  // namespace farrier::cli
