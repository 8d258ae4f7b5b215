"""EMF: models of the ASEME IDE and of KSE, read from their XMI files and said in `.aseme` text."""
