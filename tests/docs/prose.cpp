#include "prose.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>

#include "documents.hpp"

namespace farrier::docs {
namespace prose {

constexpr std::size_t kMostWords = 35;
const std::set<std::string> kBadBeginnings{"What",  "Whatever", "Whether", "Who", "Whoever",
                                           "Whose", "Whom",     "Of",      "How"};

/// Sentences of one comment, each with the line where it begins.
struct Sentence {
  int line;
  std::string text;
};

/// The place where a comment begins in a line of C++; npos where there is none.
std::size_t comment_at(const std::string& line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote != 0) {
      if (line[i] == '\\') {
        ++i;
      } else if (line[i] == quote) {
        quote = 0;
      }
    } else if (line[i] == '"' ||
               (line[i] == '\'' && (i == 0 || std::isalnum(static_cast<unsigned char>(line[i - 1])) == 0))) {
      quote = line[i];
    } else if (line.compare(i, 2, "//") == 0) {
      return i;
    }
  }
  return std::string::npos;
}

bool ends_a_sentence(const std::string& word) {
  static const std::set<std::string> kAbbreviations{"e.g.", "i.e.", "Fig.", "Eq.", "vs.", "No.", "al.", "cf.", "resp."};
  return !word.empty() && (word.back() == '.' || word.back() == '?' || word.back() == '!') &&
         kAbbreviations.count(word) == 0;
}

bool begins_a_sentence(const std::string& word) {
  return std::isupper(static_cast<unsigned char>(word.front())) != 0 || word.front() == '(' || word.front() == '"';
}

struct Word {
  int line;
  std::string text;
};

std::vector<Sentence> split(const std::vector<Word>& words) {
  std::vector<Sentence> sentences;
  bool begins = true;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (begins) {
      sentences.push_back({words[i].line, words[i].text});
    } else {
      sentences.back().text += " " + words[i].text;
    }
    begins = ends_a_sentence(words[i].text) && (i + 1 == words.size() || begins_a_sentence(words[i + 1].text));
  }
  return sentences;
}

/// The sentences of all comments. Lines of comment that follow one another are one comment; one behind code stands by
/// itself.
std::vector<Sentence> sentences_of(const architecture::Source& source) {
  std::vector<Sentence> all;
  std::vector<Word> words;
  const auto close = [&] {
    std::ranges::move(split(words), std::back_inserter(all));
    words.clear();
  };
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const std::string& line = source.lines[i];
    const std::size_t place = comment_at(line);
    const bool whole_line = place != std::string::npos && line.find_first_not_of(" \t") == place;
    const bool goes_on = whole_line && i > 0 && comment_at(source.lines[i - 1]) == place;
    if (!goes_on) {
      close();
    }
    if (place == std::string::npos) {
      continue;
    }
    std::size_t text = place;
    while (text < line.size() && (line[text] == '/' || line[text] == '<')) {
      ++text;
    }
    if (line.compare(text, 11, " namespace ") == 0) {
      continue;  // the comment behind a closing brace
    }
    std::istringstream stream(line.substr(text));
    for (std::string word; stream >> word;) {
      words.push_back({static_cast<int>(i) + 1, word});
    }
  }
  close();
  return all;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// "RejectsUnknownFlag" as "rejects unknown flag".
std::string words_of_name(const std::string& name) {
  std::string words;
  for (const char c : name) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0 && !words.empty()) {
      words += ' ';
    }
    words += c;
  }
  return lower(words);
}

bool has_word(const std::string& text, const std::string& word) {
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end]))) {
      return true;
    }
  }
  return false;
}

std::size_t count_words(const std::string& text) {
  std::istringstream stream(text);
  std::size_t count = 0;
  for (std::string word; stream >> word;) {
    count += std::ranges::any_of(word, [](unsigned char c) { return std::isalnum(c) != 0; }) ? 1 : 0;
  }
  return count;
}

}  // namespace prose

std::vector<std::string> banned_words() {
  std::vector<std::string> words;
  for (const Document& document : documents()) {
    bool in_list = false;
    for (const Line& line : document.prose) {
      if (line.text.starts_with("#")) {
        in_list = document.path == "docs/style.md" && line.text.find("Banned words") != std::string::npos;
      } else if (in_list && line.text.starts_with("| `")) {
        words.push_back(prose::lower(code_spans(line.text).front()));
      }
    }
  }
  return words;
}

std::vector<Finding> prose_findings(const architecture::Source& source, const std::vector<std::string>& banned) {
  using namespace prose;
  std::vector<Finding> findings;
  for (const Sentence& sentence : sentences_of(source)) {
    const std::string first = sentence.text.substr(0, sentence.text.find_first_of(" ,.:;"));
    if (kBadBeginnings.count(first) != 0 && !sentence.text.ends_with("?")) {
      findings.push_back({sentence.line, "begins with '" + first + "'", sentence.text});
    }
    if (count_words(sentence.text) > kMostWords) {
      findings.push_back({sentence.line, "has more than 35 words", sentence.text});
    }
    for (const std::string& word : banned) {
      if (has_word(lower(sentence.text), word)) {
        findings.push_back({sentence.line, "has the banned '" + word + "'", sentence.text});
      }
    }
  }
  static const std::regex test(R"(^TEST(_F|_P)?\((\w+), *(\w+)\))");
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_search(source.lines[i], match, test)) {
      continue;
    }
    const std::string name = words_of_name(match[3]);
    std::vector<std::string> phrases = banned;
    phrases.insert(phrases.end(), {"that is none", "that are none", "is none"});
    for (const std::string& phrase : phrases) {
      if (has_word(name, phrase)) {
        findings.push_back({static_cast<int>(i) + 1, "has '" + phrase + "'", match[3]});
        break;
      }
    }
  }
  std::ranges::stable_sort(findings, {}, &Finding::line);
  return findings;
}

}  // namespace farrier::docs
