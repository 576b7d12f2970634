#include "analysis/publication/dateless_pdf.h"

#include <exception>
#include <memory>

#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>

#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

void forget_date(QPDF& pdf) {
  QPDFObjectHandle trailer = pdf.getTrailer();
  trailer.removeKey("/ID");  // which may follow from the date
  QPDFObjectHandle information = trailer.getKey("/Info");
  if (information.isDictionary()) {
    information.removeKey("/CreationDate");
  }
}

std::string written(QPDF& pdf) {
  QPDFWriter writer(pdf);
  writer.setOutputMemory();
  writer.setDeterministicID(true);
  writer.write();
  const std::shared_ptr<Buffer> bytes = writer.getBufferSharedPointer();
  return {bytes->getBuffer(), bytes->getBuffer() + bytes->getSize()};
}

}  // namespace

std::string dateless_pdf(const std::string& pdf) {
  try {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("PDF", pdf.data(), pdf.size());
    forget_date(document);
    return written(document);
  } catch (const std::exception& fault) {
    throw Error("gnuplot", std::string("gave no PDF: ") + fault.what(),
                "check that gnuplot 5.4 or newer is installed");
  }
}

}  // namespace foveola::analysis
