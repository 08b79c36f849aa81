module cairn

go 1.21
