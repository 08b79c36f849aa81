module hinges

go 1.21

require cairn v0.0.0

replace cairn => ../../go
