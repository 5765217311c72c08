// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/introduction.hpp"

#include "coupler_lib/coupling/text_packet.hpp"
#include "coupler_lib/foundation/check.hpp"

namespace coupler {

std::string launch_line(const std::vector<LaunchSegment>& segments, const std::map<std::string, int>& ranks)
{
    std::string line;
    for (const LaunchSegment& segment : segments) {
        const auto counted = ranks.find(segment.role);
        line += base::text(line.empty() ? "mpirun" : " :", " -n ", counted == ranks.end() ? 1 : counted->second, " ",
                           segment.command);
    }
    return line;
}

std::string pack(const Introduction& introduction)
{
    TextPacker packer;
    packer.put(introduction.role);
    packer.put(introduction.expected_roles);
    packer.put(introduction.config_file);
    packer.put(introduction.config_hash);
    packer.put(introduction.program);
    packer.put(introduction.own_file);
    packer.put(introduction.own_hash);
    packer.put(introduction.version);
    packer.put(introduction.libraries);
    packer.put(static_cast<int>(introduction.launch.size()));
    for (const LaunchSegment& segment : introduction.launch) {
        packer.put(segment.role);
        packer.put(segment.command);
    }
    packer.put(introduction.failure);
    packer.put(introduction.host);
    packer.put(introduction.failure_code);
    packer.put(introduction.pid);
    packer.put(introduction.appnum);
    return packer.text();
}

Introduction unpack_introduction(const std::string& text)
{
    TextUnpacker unpacker(text);
    Introduction introduction;
    unpacker.take(introduction.role);
    unpacker.take(introduction.expected_roles);
    unpacker.take(introduction.config_file);
    unpacker.take(introduction.config_hash);
    unpacker.take(introduction.program);
    unpacker.take(introduction.own_file);
    unpacker.take(introduction.own_hash);
    unpacker.take(introduction.version);
    unpacker.take(introduction.libraries);
    int segments = 0;
    unpacker.take(segments);
    for (int k = 0; k < segments; ++k) {
        LaunchSegment& segment = introduction.launch.emplace_back();
        unpacker.take(segment.role);
        unpacker.take(segment.command);
    }
    unpacker.take(introduction.failure);
    unpacker.take(introduction.host);
    unpacker.take(introduction.failure_code);
    unpacker.take(introduction.pid);
    unpacker.take(introduction.appnum);
    return introduction;
}

} // namespace coupler
