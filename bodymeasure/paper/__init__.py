"""The paper, reproduced: Ng, Pong and Wong (2007)."""
