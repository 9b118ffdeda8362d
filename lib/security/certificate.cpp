#include "security/certificate.hpp"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/x509.h>
#include <openssl/x509_vfy.h>

#include <memory>

namespace farrier::security {
namespace {

template <auto kFree>
struct Free {
  template <class T>
  void operator()(T* object) const noexcept {
    kFree(object);
  }
};
using Bio = std::unique_ptr<BIO, Free<BIO_free_all>>;
using X509Ptr = std::unique_ptr<X509, Free<X509_free>>;
using Request = std::unique_ptr<X509_REQ, Free<X509_REQ_free>>;
using Key = std::unique_ptr<EVP_PKEY, Free<EVP_PKEY_free>>;
using Store = std::unique_ptr<X509_STORE, Free<X509_STORE_free>>;
using StoreContext = std::unique_ptr<X509_STORE_CTX, Free<X509_STORE_CTX_free>>;
using Pkcs7 = std::unique_ptr<PKCS7, Free<PKCS7_free>>;

/// Returns libcrypto's reason of its last failure.
std::string reason() {
  const unsigned long code = ERR_peek_last_error();
  ERR_clear_error();
  const char* const text = code == 0 ? nullptr : ERR_reason_error_string(code);
  return text == nullptr ? "no reason given" : text;
}

Bio open_file(const std::string& path) { return Bio(BIO_new_file(path.c_str(), "r")); }

X509Ptr read_x509(const std::string& path) {
  const Bio file = open_file(path);
  return X509Ptr(file == nullptr ? nullptr : PEM_read_bio_X509(file.get(), nullptr, nullptr, nullptr));
}

Error not_a_certificate(const std::string& path) { return Error{path + " is not a certificate (PEM): " + reason()}; }

std::string text_of(BIO& memory) {
  char* bytes = nullptr;
  const long size = BIO_get_mem_data(&memory, &bytes);
  return std::string(bytes, static_cast<std::size_t>(size));
}

std::time_t time_of(const ASN1_TIME* time) {
  std::tm parts{};
  return ASN1_TIME_to_tm(time, &parts) == 1 ? ::timegm(&parts) : 0;
}

std::array<std::uint8_t, 32> hash_of(const X509_NAME* name) {
  std::array<std::uint8_t, 32> hash{};
  unsigned size = hash.size();
  X509_NAME_digest(name, EVP_sha256(), hash.data(), &size);
  return hash;
}

/// A store that trusts this CA alone and asks no certificate for its dates.
Store store_of(X509& ca) {
  Store store(X509_STORE_new());
  X509_STORE_add_cert(store.get(), &ca);
  X509_STORE_set_flags(store.get(), X509_V_FLAG_NO_CHECK_TIME);
  return store;
}

/// No passphrase is asked for on the terminal.
int no_passphrase(char*, int, int, void*) { return 0; }

}  // namespace

Result<Certificate> read_certificate(const std::string& path) {
  const X509Ptr x509 = read_x509(path);
  if (x509 == nullptr) {
    return not_a_certificate(path);
  }
  const X509_NAME* const subject = X509_get_subject_name(x509.get());
  const Bio text(BIO_new(BIO_s_mem()));
  X509_NAME_print_ex(text.get(), subject, 0, XN_FLAG_RFC2253);
  return Certificate{text_of(*text), time_of(X509_get0_notBefore(x509.get())), time_of(X509_get0_notAfter(x509.get())),
                     hash_of(subject)};
}

Result<std::array<std::uint8_t, 32>> subject_hash_of_request(const std::string& path) {
  const Bio file = open_file(path);
  const Request request(file == nullptr ? nullptr : PEM_read_bio_X509_REQ(file.get(), nullptr, nullptr, nullptr));
  if (request == nullptr) {
    return Error{path + " is not a certificate request (PEM): " + reason()};
  }
  return hash_of(X509_REQ_get_subject_name(request.get()));
}

bool suits(const std::array<std::uint8_t, 32>& subject_hash, bus::Vendor vendor) noexcept {
  const bool upper_half = subject_hash[0] >= 0x80;
  return upper_half == (vendor == bus::Vendor::kFast);
}

Result<Done> issued_by(const std::string& certificate_path, const std::string& ca_path) {
  const X509Ptr certificate = read_x509(certificate_path);
  if (certificate == nullptr) {
    return not_a_certificate(certificate_path);
  }
  const X509Ptr ca = read_x509(ca_path);
  if (ca == nullptr) {
    return not_a_certificate(ca_path);
  }
  const Store store = store_of(*ca);
  const StoreContext context(X509_STORE_CTX_new());
  X509_STORE_CTX_init(context.get(), store.get(), certificate.get(), nullptr);
  if (X509_verify_cert(context.get()) != 1) {
    const char* const why = X509_verify_cert_error_string(X509_STORE_CTX_get_error(context.get()));
    return Error{certificate_path + " was not issued by " + ca_path + " (" + why + ")"};
  }
  return Done{};
}

Result<Done> belongs_to(const std::string& key_path, const std::string& certificate_path) {
  const Bio file = open_file(key_path);
  const Key key(file == nullptr ? nullptr : PEM_read_bio_PrivateKey(file.get(), nullptr, no_passphrase, nullptr));
  if (key == nullptr) {
    return Error{key_path + " is not a private key without passphrase (PEM): " + reason()};
  }
  const X509Ptr certificate = read_x509(certificate_path);
  if (certificate == nullptr) {
    return not_a_certificate(certificate_path);
  }
  if (X509_check_private_key(certificate.get(), key.get()) != 1) {
    ERR_clear_error();
    return Error{key_path + " is not the key of " + certificate_path};
  }
  return Done{};
}

Result<std::string> signed_text(const std::string& path, const std::string& ca_path) {
  const X509Ptr ca = read_x509(ca_path);
  if (ca == nullptr) {
    return not_a_certificate(ca_path);
  }
  const Bio file = open_file(path);
  BIO* apart = nullptr;
  const Pkcs7 document(file == nullptr ? nullptr : SMIME_read_PKCS7(file.get(), &apart));
  const Bio content(apart);
  if (document == nullptr) {
    return Error{path + " is not a signed document (S/MIME): " + reason()};
  }
  const Store store = store_of(*ca);
  const Bio text(BIO_new(BIO_s_mem()));
  if (PKCS7_verify(document.get(), nullptr, store.get(), content.get(), text.get(), PKCS7_TEXT) != 1) {
    return Error{path + " was not signed by " + ca_path + ", or changed since (" + reason() + ")"};
  }
  return text_of(*text);
}

}  // namespace farrier::security
