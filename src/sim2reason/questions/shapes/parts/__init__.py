"""What shapes of prompts share."""
