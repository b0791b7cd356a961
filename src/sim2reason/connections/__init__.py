"""What joins the ports of entities, one file each."""
