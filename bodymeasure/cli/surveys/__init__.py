"""Commands on many bodies: surveys and tables of sizes."""
