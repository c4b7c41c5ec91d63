"""Commands about an atlas: check, convert, info, samples."""
