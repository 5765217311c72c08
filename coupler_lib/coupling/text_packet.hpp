// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/foundation/check.hpp"

#include <cstring>
#include <string>
#include <vector>

namespace coupler {

/// Strings and integers one after the other in one message; each string is preceded by its length.
class TextPacker {
public:
    void put(int value) { text_.append(reinterpret_cast<const char*>(&value), sizeof(value)); }
    void put(const std::string& value)
    {
        put(static_cast<int>(value.size()));
        text_ += value;
    }
    void put(const std::vector<std::string>& values)
    {
        put(static_cast<int>(values.size()));
        for (const auto& value : values) put(value);
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Takes out what TextPacker put in, in the same order. Throws base::Error(bad_input) when the text is cut short.
class TextUnpacker {
public:
    explicit TextUnpacker(const std::string& text) : text_(text) {}

    void take(int& value)
    {
        need(sizeof(value));
        std::memcpy(&value, text_.data() + at_, sizeof(value));
        at_ += sizeof(value);
    }
    void take(std::string& value)
    {
        int length = 0;
        take(length);
        need(static_cast<std::size_t>(length));
        value = text_.substr(at_, static_cast<std::size_t>(length));
        at_ += static_cast<std::size_t>(length);
    }
    void take(std::vector<std::string>& values)
    {
        int count = 0;
        take(count);
        need(static_cast<std::size_t>(count));
        values.resize(static_cast<std::size_t>(count));
        for (auto& value : values) take(value);
    }

private:
    void need(std::size_t bytes) const
    {
        base::require_input(bytes <= text_.size() - at_, "a start-up message is cut short at byte ", at_, " of ",
                            text_.size(), ": is the other program of another version?");
    }
    const std::string& text_;
    std::size_t at_ = 0;
};

} // namespace coupler
