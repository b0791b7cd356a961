"""What models share: how a checkpoint is read, and how a tokenizer is made."""
