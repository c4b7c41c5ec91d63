"""The paper's section 6.3: lengths on a body's surface, and Table 5."""
