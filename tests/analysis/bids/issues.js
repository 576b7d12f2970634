// Lists what bids-validator found: every error, and every warning but the accepted ones, as
//   CODE: FILE: REASON
// with the first file of each.
//
// node issues.js FOUND ACCEPTED...
//
// FOUND is what bids-validator --json printed, ACCEPTED the codes of warnings. An accepted warning
// that was not given is listed, too.
'use strict';

const [found, ...accepted] = process.argv.slice(2);
const {issues} = JSON.parse(require('fs').readFileSync(found, 'utf8'));

for (const issue of issues.errors.concat(issues.warnings)) {
  if (issue.severity === 'error' || !accepted.includes(issue.key)) {
    const {file, evidence} = issue.files[0];
    const what = [evidence, issue.reason].filter(Boolean).join(': ');
    console.log(`${issue.key}: ${file ? file.relativePath : 'the dataset'}: ${what}`);
  }
}
for (const key of accepted) {
  if (!issues.warnings.some((warning) => warning.key === key)) {
    console.log(`${key}: the dataset: is accepted, but not warned of any more`);
  }
}
