let rec gcd a b = if b = 0 then a else gcd b (a mod b)

(* In steps of about the golden section, and without a common factor, so that all come up. *)
let iter f a =
  let n = Array.length a in
  let rec coprime k = if gcd n k = 1 then k else coprime (k + 1) in
  let step = coprime (Int.max 1 (n * 618 / 1000)) in
  for i = 0 to n - 1 do
    f a.(i * step mod n)
  done
