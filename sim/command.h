#pragma once
namespace sim { struct Command { bool operator==(const Command&) const = default; }; }
