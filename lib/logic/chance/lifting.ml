open Scc_exact
open Scc_data

type given_up = Interrupted | Too_long | Too_much
type solution = { numerators : Z.t array; denominator : Z.t; steps : int }

exception Given_up of given_up

(* Rows of A, each times the least number that makes it integers; where these are short, as small ones. Constants
   are times the number of their row, and one more for all, [unit]. *)
type row = { columns : int array; entries : int array; long : Z.t array }
type system = { rows : row array; constants : Z.t array; unit : Z.t }

(* The sum of the entries of a short row. A residual is at most that times p, and what is added to it. *)
let most = 1 lsl 32

let row_of entries =
  let entries = List.filter (fun (_, a) -> Rat.sign a <> 0) entries in
  let scale = List.fold_left (fun l (_, (a : Rat.t)) -> Z.lcm l a.den) Z.one entries in
  let scaled (_, (a : Rat.t)) = Z.mul a.num (Z.divexact scale a.den) in
  let long = Array.of_list (List.map scaled entries) in
  let sum = Array.fold_left (fun sum z -> Z.add sum (Z.abs z)) Z.zero long in
  let is_short = Z.lt sum (Z.of_int most) in
  let entries' = if is_short then Array.map Z.to_int long else [||] in
  let columns = Array.of_list (List.map fst entries) in
  ({ columns; entries = entries'; long = (if is_short then [||] else long) }, scale)

let system ~size ~row ~constant ~bits =
  let scaled = Array.init size (fun i -> row_of (row i)) in
  let constant i = Rat.mul (constant i) (Rat.make (snd scaled.(i)) Z.one) in
  let constants = Array.init size constant in
  let add unit (c : Rat.t) =
    let unit = Z.lcm unit c.den in
    if Z.numbits unit > bits then raise (Given_up Too_long);
    unit
  in
  let unit = Array.fold_left add Z.one constants in
  let whole (c : Rat.t) = Z.mul c.num (Z.divexact unit c.den) in
  { rows = Array.map fst scaled; constants = Array.map whole constants; unit }

let is_short row = Array.length row.long = 0

let neighbours s =
  let n = Array.length s.rows in
  let all = Array.make n [] in
  Array.iteri
    (fun i row ->
       Array.iter
         (fun j ->
            if not (Int.equal i j) then begin
              all.(i) <- j :: all.(i);
              all.(j) <- i :: all.(j)
            end)
         row.columns)
    s.rows;
  Array.map (fun l -> Array.of_list (List.sort_uniq Int.compare l)) all

(* {1 Digits} *)

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

(* The digits of a number, each with its sign. *)
let digits powers z =
  let found = Int_array.buffer () in
  let rec put z ~count =
    if count = 1 then Int_array.push found (Z.to_int z)
    else
      let half = count / 2 in
      let high, low = Z.div_rem z (powers half) in
      put low ~count:half;
      put high ~count:(count - half)
  in
  if Z.sign z <> 0 then put z ~count:(1 + (Z.numbits z / 27));
  Int_array.contents found

let residue p a =
  let r = a mod p in
  if r < 0 then r + p else r

(* What is left of the right side, divided by the power of p that was reached, but for digits of the constants that
   come later: small numbers for short rows, and others. *)
type residual = { s : system; p : int; of_constants : Int_array.t array; small : int array; others : Z.t array }

let coming r k i =
  let digits = r.of_constants.(i) in
  if k < Int_array.length digits then Int_array.get digits k else 0

let start s p power =
  let of_constants = Array.map (digits power) s.constants in
  let n = Array.length s.rows in
  let r = { s; p; of_constants; small = Array.make n 0; others = Array.make n Z.zero } in
  for i = 0 to n - 1 do
    r.small.(i) <- coming r 0 i;
    r.others.(i) <- Z.of_int r.small.(i)
  done;
  r

let modulo_p r (x : int array) =
  Array.iteri
    (fun i row ->
       x.(i) <-
         (if is_short row then residue r.p r.small.(i) else Z.to_int (Z.erem r.others.(i) (Z.of_int r.p))))
    r.s.rows

(* After digit k of the solution. *)
let go_on r k (digit : int array) =
  Array.iteri
    (fun i row ->
       if is_short row then begin
         let sum = ref r.small.(i) in
         for e = 0 to Array.length row.columns - 1 do
           sum := !sum - (Array.unsafe_get row.entries e * Array.unsafe_get digit (Array.unsafe_get row.columns e))
         done;
         r.small.(i) <- (!sum / r.p) + coming r (k + 1) i
       end
       else begin
         let sum = ref r.others.(i) in
         Array.iteri (fun e j -> sum := Z.sub !sum (Z.mul row.long.(e) (Z.of_int digit.(j)))) row.columns;
         r.others.(i) <- Z.add (Z.divexact !sum (Z.of_int r.p)) (Z.of_int (coming r (k + 1) i))
       end)
    r.s.rows

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
let over_one_denominator m ~size value =
  let most = Z.numbits m / 2 in
  let times den z = symmetric (Z.erem (Z.mul z den) m) m in
  let known = Array.make size Z.zero in
  let rec from i den =
    if i = size then Some (Array.map (times den) known, den)
    else begin
      known.(i) <- value i;
      let t = times den known.(i) in
      if Z.numbits t + Z.numbits den < most + (most / 2) then from (i + 1) den
      else
        let den = Z.mul den (snd (fraction (Z.erem t m) m)) in
        if Z.sign den = 0 || Z.numbits den > most then None else from (i + 1) den
    end
  in
  from 0 Z.one

(* The proof: the rows, times the denominator. *)
let is_solution s (numerators, denominator) =
  let holds i row =
    let sum = ref Z.zero in
    Array.iteri
      (fun e j ->
         let a = if is_short row then Z.of_int row.entries.(e) else row.long.(e) in
         sum := Z.add !sum (Z.mul a numerators.(j)))
      row.columns;
    Z.equal !sum (Z.mul denominator s.constants.(i))
  in
  let n = Array.length s.rows in
  let rec all i = i = n || (holds i s.rows.(i) && all (i + 1)) in
  Z.sign denominator > 0 && all 0

(* {1 Solving} *)

let first_prime = Factors.prime_below (1 lsl 28)

(* The first prime for which no pivot is 0 modulo it. *)
let rec factors s ~order ~neighbours ~interrupted p =
  let row i put =
    let { columns; entries; long } = s.rows.(i) in
    let reduced e =
      if Array.length long = 0 then residue p entries.(e) else Z.to_int (Z.erem long.(e) (Z.of_int p))
    in
    Array.iteri (fun e j -> put j (reduced e)) columns
  in
  match Factors.compute ~p ~order ~neighbours ~row ~interrupted with
  | Some f -> (p, f)
  | None when interrupted () -> raise (Given_up Interrupted)
  | None -> factors s ~order ~neighbours ~interrupted (Factors.prime_below p)

let lift s p f ~bits ~taken ~steps ~interrupted =
  let n = Array.length s.rows in
  let power = powers p in
  let r = start s p power in
  let limit = 4 + ((2 * (bits + Z.numbits s.unit)) / 27) in
  let entries = Array.fold_left (fun sum row -> sum + Array.length row.columns) 0 s.rows in
  let cost = Factors.entries f + entries + (2 * n) in
  (* Digit k of all unknowns, and then the next one. *)
  let found = Int_array.buffer () and x = Array.make n 0 in
  let value count i = number power (fun k -> Int_array.nth found ((k * n) + i)) ~first:0 ~count in
  let rec go k next taken =
    if k = limit then raise (Given_up Too_long);
    if taken > steps then raise (Given_up Too_much);
    if interrupted () then raise (Given_up Interrupted);
    modulo_p r x;
    Factors.solve f x;
    Array.iter (Int_array.push found) x;
    go_on r k x;
    if k + 1 < next && k + 1 < limit then go (k + 1) next (taken + cost)
    else
      match over_one_denominator (power (k + 1)) ~size:n (value (k + 1)) with
      | Some ((numerators, denominator) as found) when is_solution s found ->
        { numerators; denominator = Z.mul denominator s.unit; steps = taken + cost }
      | Some _ | None -> go (k + 1) (next + Int.max 2 (next / 2)) (taken + cost)
  in
  go 0 4 taken

let solve ~size ~row ~constant ~bits ~steps ~interrupted =
  match
    let s = system ~size ~row ~constant ~bits in
    let neighbours = neighbours s in
    match Fill_order.compute ~neighbours ~most:steps ~interrupted with
    | None -> raise (Given_up (if interrupted () then Interrupted else Too_much))
    | Some { order; steps = taken } ->
      let p, f = factors s ~order ~neighbours ~interrupted first_prime in
      lift s p f ~bits ~taken ~steps ~interrupted
  with
  | found -> Ok found
  | exception Given_up why -> Error why
