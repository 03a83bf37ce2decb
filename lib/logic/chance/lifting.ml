open Scc_exact

type given_up = Interrupted | Too_long | Unfit

exception Given_up of given_up

(* Rows of I - P, each times the least number that makes it and its constant integers, without those that are 0. *)
type system = { columns : int array array; entries : int array array; constants : int array }

(* A residual is at most as long as a row times p, and what is added to it. *)
let most = 1 lsl 30

let row_of i ~row ~constant =
  let entries = List.filter (fun (_, a) -> Rat.sign a <> 0) row in
  let all = constant :: List.map snd entries in
  let scale = List.fold_left (fun l (a : Rat.t) -> Z.lcm l a.den) Z.one all in
  let scaled (a : Rat.t) =
    let z = Z.mul a.num (Z.divexact scale a.den) in
    if Z.numbits z > 30 then raise (Given_up Unfit);
    Z.to_int z
  in
  let entries = List.map (fun (j, a) -> (j, scaled a)) entries in
  let sum = List.fold_left (fun sum (_, a) -> sum + abs a) (abs (scaled constant)) entries in
  if sum >= most || not (List.exists (fun (j, _) -> Int.equal i j) entries) then raise (Given_up Unfit);
  (entries, scaled constant)

let system ~size ~row ~constant =
  let rows = Array.init size (fun i -> row_of i ~row:(row i) ~constant:(constant i)) in
  {
    columns = Array.map (fun (entries, _) -> Array.of_list (List.map fst entries)) rows;
    entries = Array.map (fun (entries, _) -> Array.of_list (List.map snd entries)) rows;
    constants = Array.map snd rows;
  }

(* {1 Modulo a prime} *)

(* The greatest primes below 2^30. *)
let primes = [ 1_073_741_789; 1_073_741_783; 1_073_741_741 ]

let residue p a =
  let r = a mod p in
  if r < 0 then r + p else r

let inverse p a =
  let rec go r r' s s' = if r' = 0 then residue p s else go r' (r mod r') s' (s - (r / r' * s')) in
  go a p 1 0

(* Of rows in the order of their length, the lower and the upper factor in one; the diagonal has its inverses.
   Pivots are on the diagonal, where they are not 0 but by chance. *)
type factors = { p : int; order : int array; lu : int array array }

let eliminate ~interrupted p (a : int array array) =
  let n = Array.length a in
  let rec go k =
    k = n
    ||
    let pivot = a.(k) in
    if k land 15 = 0 && interrupted () then raise (Given_up Interrupted);
    pivot.(k) <> 0
    && begin
      pivot.(k) <- inverse p pivot.(k);
      for i = k + 1 to n - 1 do
        let under = a.(i) in
        if under.(k) <> 0 then begin
          let l = under.(k) * pivot.(k) mod p in
          under.(k) <- l;
          let minus = p - l in
          for j = k + 1 to n - 1 do
            let u = Array.unsafe_get pivot j in
            if u <> 0 then Array.unsafe_set under j ((Array.unsafe_get under j + (minus * u)) mod p)
          done
        end
      done;
      go (k + 1)
    end
  in
  go 0

let factors ~interrupted s p =
  let n = Array.length s.constants in
  let order = Array.init n Fun.id in
  let length i = Array.length s.columns.(i) in
  Array.stable_sort (fun i j -> Int.compare (length i) (length j)) order;
  let place = Array.make n 0 in
  Array.iteri (fun k i -> place.(i) <- k) order;
  let line i =
    let line = Array.make n 0 in
    Array.iteri (fun e j -> line.(place.(j)) <- residue p s.entries.(i).(e)) s.columns.(i);
    line
  in
  let lu = Array.map line order in
  if eliminate ~interrupted p lu then Some { p; order; lu } else None

(* The solution modulo p for a right side. *)
let solved f (right : int array) =
  let n = Array.length f.order in
  let x = Array.map (fun i -> residue f.p right.(i)) f.order in
  for i = 0 to n - 1 do
    let line = f.lu.(i) and sum = ref x.(i) in
    for j = 0 to i - 1 do
      let l = Array.unsafe_get line j in
      if l <> 0 then sum := (!sum + ((f.p - l) * Array.unsafe_get x j)) mod f.p
    done;
    x.(i) <- !sum
  done;
  for i = n - 1 downto 0 do
    let line = f.lu.(i) and sum = ref x.(i) in
    for j = i + 1 to n - 1 do
      let u = Array.unsafe_get line j in
      if u <> 0 then sum := (!sum + ((f.p - u) * Array.unsafe_get x j)) mod f.p
    done;
    x.(i) <- !sum * line.(i) mod f.p
  done;
  let found = Array.make n 0 in
  Array.iteri (fun k i -> found.(i) <- x.(k)) f.order;
  found

(* {1 Digits} *)

(* What is left of the right side after a digit: a multiple of p, divided by it. *)
let rest s p (right : int array) (digit : int array) =
  let one i b =
    let sum = ref b in
    Array.iteri (fun e j -> sum := !sum - (s.entries.(i).(e) * digit.(j))) s.columns.(i);
    !sum / p
  in
  Array.mapi one right

(* The number with these digits to the base p, the lowest first. *)
let rec number powers digit ~first ~count =
  if count = 1 then Z.of_int (digit first)
  else
    let half = count / 2 in
    let low = number powers digit ~first ~count:half in
    let high = number powers digit ~first:(first + half) ~count:(count - half) in
    Z.add low (Z.mul (powers half) high)

let powers p =
  let known = Hashtbl.create 16 in
  fun n ->
    match Hashtbl.find_opt known n with
    | Some power -> power
    | None ->
      let power = Z.pow (Z.of_int p) n in
      Hashtbl.add known n power;
      power

(* {1 Fractions} *)

let symmetric z m = if Z.gt (Z.shift_left z 1) m then Z.sub z m else z

(* The fraction with a numerator of at most half the length of m that is t modulo m. *)
let fraction t m =
  let enough = Z.shift_left Z.one (Z.numbits m / 2) in
  let rec go r r' s s' =
    if Z.lt (Z.abs r') enough then (r', s')
    else
      let q, rest = Z.div_rem r r' in
      go r' rest s' (Z.sub s (Z.mul q s'))
  in
  let num, den = go m t Z.zero Z.one in
  if Z.sign den < 0 then (Z.neg num, Z.neg den) else (num, den)

(* All values over one denominator, as far as these digits tell: a guess. Most values are short by the denominator
   of those before. Nothing is found where it grows too long. *)
let over_one_denominator m (values : Z.t array) =
  let most = Z.numbits m / 2 in
  let times den z = symmetric (Z.erem (Z.mul z den) m) m in
  let rec from i den =
    if i = Array.length values then Some (Array.map (times den) values, den)
    else
      let t = times den values.(i) in
      if Z.numbits t + Z.numbits den < most + (most / 2) then from (i + 1) den
      else
        let den = Z.mul den (snd (fraction (Z.erem t m) m)) in
        if Z.sign den = 0 || Z.numbits den > most then None else from (i + 1) den
  in
  from 0 Z.one

(* The proof: the rows, times the denominator. *)
let is_solution s x den =
  let row i b =
    let sum = ref Z.zero in
    Array.iteri (fun e j -> sum := Z.add !sum (Z.mul (Z.of_int s.entries.(i).(e)) x.(j))) s.columns.(i);
    Z.equal !sum (Z.mul den (Z.of_int b))
  in
  Z.sign den > 0 && Array.for_all Fun.id (Array.mapi row s.constants)

let solve ~size ~row ~constant ~bits ~interrupted =
  let look s f =
    let limit = 4 + ((2 * bits) / 29) in
    let digits = Array.make limit [||] and right = ref s.constants in
    let power = powers f.p in
    let value count i = number power (fun k -> digits.(k).(i)) ~first:0 ~count in
    let rec lift k next =
      if k = limit then raise (Given_up Too_long);
      if interrupted () then raise (Given_up Interrupted);
      digits.(k) <- solved f !right;
      right := rest s f.p !right digits.(k);
      if k + 1 < next && k + 1 < limit then lift (k + 1) next
      else
        match over_one_denominator (power (k + 1)) (Array.init size (value (k + 1))) with
        | Some (x, den) when is_solution s x den -> (x, den)
        | Some _ | None -> lift (k + 1) (next + (next / 2))
    in
    lift 0 16
  in
  match
    let s = system ~size ~row ~constant in
    match List.find_map (factors ~interrupted s) primes with
    | None -> raise (Given_up Unfit)
    | Some f -> look s f
  with
  | x, den ->
    let values = Array.map (fun num -> Rat.make num den) x in
    if Array.exists (fun x -> Rat.bits x > bits) values then Error Too_long else Ok values
  | exception Given_up why -> Error why
