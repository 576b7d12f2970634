#include "analysis/publication/dateless_pdf.h"

#include <memory>

// By its interface in C: the headers of that in C++ do not compile with Clang in C++20.
#include <qpdf/qpdf-c.h>

#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

struct Cleanup {
  void operator()(qpdf_data document) const { qpdf_cleanup(&document); }
};
using Document = std::unique_ptr<_qpdf_data, Cleanup>;

// Throws Error for what went wrong since it was asked last.
void check(const Document& document) {
  if (qpdf_has_error(document.get()) == QPDF_TRUE) {
    const char* why = qpdf_get_error_full_text(document.get(), qpdf_get_error(document.get()));
    throw Error("gnuplot", std::string("gave no PDF: ") + why,
                "check that gnuplot 5.4 or newer is installed");
  }
}

Document read(const std::string& pdf) {
  Document document(qpdf_init());
  qpdf_silence_errors(document.get());
  qpdf_set_suppress_warnings(document.get(), QPDF_TRUE);
  qpdf_read_memory(document.get(), "PDF", pdf.data(), pdf.size(), nullptr);
  check(document);
  return document;
}

void forget_date(const Document& document) {
  const qpdf_oh trailer = qpdf_get_trailer(document.get());
  qpdf_oh_remove_key(document.get(), trailer, "/ID");  // which may follow from the date
  const qpdf_oh information = qpdf_oh_get_key(document.get(), trailer, "/Info");
  if (qpdf_oh_is_dictionary(document.get(), information) == QPDF_TRUE) {
    qpdf_oh_remove_key(document.get(), information, "/CreationDate");
  }
  check(document);
}

std::string written(const Document& document) {
  qpdf_init_write_memory(document.get());
  qpdf_set_deterministic_ID(document.get(), QPDF_TRUE);
  qpdf_write(document.get());
  check(document);
  const unsigned char* bytes = qpdf_get_buffer(document.get());
  return {bytes, bytes + qpdf_get_buffer_length(document.get())};
}

}  // namespace

std::string dateless_pdf(const std::string& pdf) {
  const Document document = read(pdf);
  forget_date(document);
  return written(document);
}

}  // namespace foveola::analysis
