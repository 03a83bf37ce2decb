open Scc_exact
open Scc_ctl
open Scc_codec

let put b ({ offset; attained } : Timeline.moment) =
  Progress.put_bool b attained;
  match offset with
  | Rational r ->
    Packed.put_nat b 0;
    Packed.put_rational b r
  | Irrational { polynomial; low; high } ->
    Packed.put_nat b 1;
    Packed.put_list b Packed.put_rational (Polynomial.coefficients polynomial);
    Packed.put_rational b low;
    Packed.put_rational b high

let sign_at p r = Algebraic.sign_at p (Algebraic.of_rat r)

let read source : Timeline.moment =
  let attained = Progress.read_bool source in
  if Packed.below 2 ~what:"the kind of a number" source = 0 then
    { offset = Algebraic.of_rat (Packed.rational source); attained }
  else
    let polynomial = Polynomial.of_coefficients (Packed.list source Packed.rational) in
    let low = Packed.rational source in
    let high = Packed.rational source in
    if Rat.compare low high >= 0 || sign_at polynomial low * sign_at polynomial high >= 0 then
      raise (Packed.Malformed "a root is between no such bounds");
    { offset = Algebraic.isolated polynomial ~low ~high; attained }
