type need = Positive | Not_negative

let holds need sign = match need with Positive -> sign > 0 | Not_negative -> sign >= 0
let contact = Not_negative
let overlap = Positive
let collision ~speed = if speed < 0 then contact else overlap

type times = From | Until | Always_or_never

let times ~speed = if speed < 0 then From else if speed > 0 then Until else Always_or_never
