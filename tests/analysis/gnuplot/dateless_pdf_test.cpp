
#include "analysis/gnuplot/gnuplot.h"
#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::string pdf_of(const std::string& date) {
  const std::string catalog = "1 0 obj\n<</Type/Catalog/Pages 2 0 R>>\nendobj\n";
  const std::string pages = "2 0 obj\n<</Type/Pages/Kids[4 0 R]/Count 1>>\nendobj\n";
  const std::string information =
      "3 0 obj\n<</Producer(somebody)/CreationDate(D:" + date + ")>>\nendobj\n";
  const std::string page = "4 0 obj\n<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]>>\nendobj\n";
  return "%PDF-1.4\n" + catalog + pages + information + page +
         "trailer\n<</Size 5/Root 1 0 R/Info 3 0 R/ID[<" + date + "><" + date + ">]>>\n%%EOF\n";
}

TEST(DatelessPdf, IsTheSameWheneverItWasMade) {
  const std::string pdf = dateless_pdf(pdf_of("20261127120000"));
  EXPECT_EQ(pdf, dateless_pdf(pdf_of("20261127120001")));
  EXPECT_THAT(pdf, AllOf(HasSubstr("somebody"), Not(HasSubstr("CreationDate"))));
}

TEST(DatelessPdf, StaysAPdf) {
  const std::string drawn = run_gnuplot("set terminal pdfcairo\nplot [0:1] x\n");
  const std::string pdf = dateless_pdf(drawn);
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_EQ(pdf, dateless_pdf(pdf));
}

TEST(DatelessPdf, OfWhatIsNoPdfIsAnError) {
  EXPECT_THAT([] { (void)dateless_pdf("no PDF"); },
              ThrowsMessage<Error>(HasSubstr("wrote no valid PDF")));
}

}  // namespace
}  // namespace foveola::analysis
