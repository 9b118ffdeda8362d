#pragma once

// Certificates, keys and signed documents as DDS Security uses them, read by the library that both vendors read them by.

#include <array>
#include <cstdint>
#include <ctime>
#include <string>

#include "bus/bus.hpp"
#include "core/result.hpp"

namespace farrier::security {

struct Certificate {
  std::string subject;    ///< RFC 2253: "CN=joint_node.cyclone.1,O=hyq"
  std::time_t not_before = 0;
  std::time_t not_after = 0;
  std::array<std::uint8_t, 32> subject_hash{};  ///< SHA-256 of the DER form of the subject
};

/// Reads a certificate (PEM). Refuses, naming the file.
Result<Certificate> read_certificate(const std::string& path);

/// SHA-256 of the DER form of the subject that a certificate request (PEM) asks for.
Result<std::array<std::uint8_t, 32>> subject_hash_of_request(const std::string& path);

/// True when DDS Security lets a participant with this subject take the part that its vendor must take in a handshake
/// with the other. The participant with the lower subject hash begins; Fast DDS 2.9 sends Cyclone DDS 0.10 a key that it
/// cannot read when Fast begins. So Cyclone's hashes have their first bit clear, Fast's have it set.
bool suits(const std::array<std::uint8_t, 32>& subject_hash, bus::Vendor vendor) noexcept;

/// Refuses a certificate that the CA did not issue. Says nothing of dates.
Result<Done> issued_by(const std::string& certificate_path, const std::string& ca_path);

/// Refuses a private key (PEM, without passphrase) that is not the certificate's.
Result<Done> belongs_to(const std::string& key_path, const std::string& certificate_path);

/// The text of a document that the CA signed (S/MIME). Refuses others, naming the file.
Result<std::string> signed_text(const std::string& path, const std::string& ca_path);

}  // namespace farrier::security
