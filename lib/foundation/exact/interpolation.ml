(* The points modulo a prime; none where it divides a denominator, or where points become one. *)
let residues p points =
  let reduced = Array.map (fun (x, y) -> (Modular.reduce p x, Modular.reduce p y)) points in
  let known = function Some x, Some y -> (x, y) | _ -> (-1, -1) in
  let all = Array.map known reduced in
  let at = Array.map fst all in
  let sorted = Array.copy at in
  Array.sort Int.compare sorted;
  let rec differ i = i >= Array.length sorted || (sorted.(i) <> sorted.(i - 1) && differ (i + 1)) in
  if Array.exists (fun x -> x < 0) at || not (differ 1) then None else Some (at, Array.map snd all)

let fraction p points =
  match residues p points with
  | None -> None
  | Some (at, values) -> Modular.fraction p ~at ~values

(* A number modulo m as a fraction with a short numerator and denominator, if it is one. *)
let reconstructed m z =
  let half = Z.sqrt (Z.shift_right m 1) in
  let rec go r s r' s' =
    if Z.leq r' half then
      if Z.sign s' <> 0 && Z.leq (Z.abs s') half then Some (Rat.make r' s') else None
    else
      let q = Z.div r r' in
      go r' s' (Z.sub r (Z.mul q r')) (Z.sub s (Z.mul q s'))
  in
  go m Z.zero (Z.erem z m) Z.one

(* All coefficients, over the denominators of those before: most have the same. *)
let all_reconstructed m coefficients =
  let add found z =
    match found with
    | None -> None
    | Some (list, d) -> (
        match reconstructed m (Z.erem (Z.mul z d) m) with
        | None -> None
        | Some q -> Some (Rat.div q (Rat.make d Z.one) :: list, Z.mul d q.den))
  in
  Option.map (fun (list, _) -> List.rev list) (Array.fold_left add (Some ([], Z.one)) coefficients)

(* Residues modulo the product of some primes, all of fractions of the same degrees. *)
type known = { modulus : Z.t; above : Z.t array; below : Z.t array }

let start p (n, d) = { modulus = Z.of_int p; above = Array.map Z.of_int n; below = Array.map Z.of_int d }

let same_shape known (n, d) =
  Array.length n = Array.length known.above && Array.length d = Array.length known.below

let joined known p (n, d) =
  let m = known.modulus in
  let inverse = Z.invert m (Z.of_int p) in
  let join z r =
    let step = Z.erem (Z.mul (Z.sub (Z.of_int r) z) inverse) (Z.of_int p) in
    Z.add z (Z.mul m step)
  in
  { modulus = Z.mul m (Z.of_int p); above = Array.map2 join known.above n; below = Array.map2 join known.below d }

let candidate known =
  match (all_reconstructed known.modulus known.below, all_reconstructed known.modulus known.above) with
  | Some d, Some n ->
    let n = Polynomial.of_coefficients n and d = Polynomial.of_coefficients d in
    if Polynomial.is_zero d then None else Some (n, d)
  | _ -> None

let through ~interrupted points =
  let passes_all f = Array.for_all (fun (x, y) -> Rational_function.passes f x y) points in
  (* Its residues have no common root, and so it has none. *)
  let accepted known =
    match candidate known with
    | None -> None
    | Some (n, d) ->
      let f = Rational_function.coprime n d in
      if passes_all f then Some f else None
  in
  (* Primes that divide a leading coefficient give other degrees. The first one may be such a prime. *)
  let rec more p known ~tried ~primes ~missed ~starts =
    if interrupted () then None
    else if missed > 3 then first p ~starts
    else
      let next = Modular.prime_below p in
      match fraction p points with
      | Some pair when same_shape known pair -> (
          let known = joined known p pair and primes = primes + 1 in
          if primes < tried then more next known ~tried ~primes ~missed ~starts
          else
            match accepted known with
            | Some f -> Some f
            | None -> more next known ~tried:(tried + 1 + (tried / 2)) ~primes ~missed ~starts)
      | Some _ | None -> more next known ~tried ~primes ~missed:(missed + 1) ~starts
  and first p ~starts =
    if starts = 0 || interrupted () then None
    else
      let next = Modular.prime_below p and starts = starts - 1 in
      match residues p points with
      | None -> first next ~starts
      | Some (at, values) -> (
          match Modular.fraction p ~at ~values with
          | None -> None
          | Some pair -> (
              let known = start p pair in
              match accepted known with
              | Some f -> Some f
              | None -> more next known ~tried:2 ~primes:1 ~missed:0 ~starts))
  in
  first Modular.first_prime ~starts:20
