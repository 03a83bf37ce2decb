open Scc_exact

let decimal = Decimal.significant ~digits:9
let short q = if Rat.is_integer q || Rat.bits q <= 24 then Rat.to_string q else decimal q
