// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace base {

/// A JSON object built key by key, in order; a key set twice keeps its last value.
class JsonObject {
public:
    JsonObject& set(const std::string& key, const std::string& value);
    JsonObject& set(const std::string& key, const char* value) { return set(key, std::string(value)); }
    JsonObject& set(const std::string& key, double value);
    JsonObject& set(const std::string& key, std::int64_t value);
    JsonObject& set(const std::string& key, int value) { return set(key, static_cast<std::int64_t>(value)); }
    JsonObject& set(const std::string& key, bool value);
    JsonObject& set(const std::string& key, const JsonObject& value);

    /// The object as text, indented by two blanks a level.
    std::string text(int level = 0) const;

private:
    struct Entry {
        std::string key, literal;
        std::vector<JsonObject> child;  // empty or one
    };
    Entry& entry(const std::string& key);
    std::vector<Entry> entries_;
};

}  // namespace base
