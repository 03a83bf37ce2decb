open Scc_exact

type t = { parameter : Ranges.range; value : Rat.t; form : Rational_function.t }

let fractions = [ (381, 997); (4751, 10_007); (61_803, 100_003); (718_281, 1_000_003); (4_142_135, 10_000_019) ]
let attempts = List.length fractions

let parameter (range : Ranges.range) ~attempt =
  let n, d = List.nth fractions attempt in
  let share = Rat.make (Z.of_int n) (Z.of_int d) in
  let value = Rat.add range.low.value (Rat.mul share (Rat.sub range.high.value range.low.value)) in
  { parameter = range; value; form = Rational_function.variable }

let vanishing (range : Ranges.range) f =
  let first p = List.nth_opt (Real_roots.all p ~low:range.low.value ~high:range.high.value) 0 in
  let numerator = Rational_function.numerator f in
  if Polynomial.is_zero numerator then None
  else match first numerator with Some x -> Some x | None -> first (Rational_function.denominator f)

let at (range : Ranges.range) x = Printf.sprintf "%s = %s" range.name (Algebraic.to_string ~variable:range.name x)

let narrower (range : Ranges.range) =
  Printf.sprintf "a narrower range, as by `-D '%s=(LOW, HIGH)'`, may leave such values out" range.name
