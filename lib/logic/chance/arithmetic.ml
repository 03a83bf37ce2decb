open Scc_exact
open Scc_data

type weights = { weight : Z.t array; sum : Z.t }

let weights p =
  let sum = Array.fold_left (fun d (x : Rat.t) -> Z.lcm d x.den) Z.one p in
  { weight = Array.map (fun (x : Rat.t) -> Z.mul x.num (Z.divexact sum x.den)) p; sum }

exception Too_long

type 'a t = {
  zero : 'a;
  one : 'a;
  integer : Z.t -> 'a;
  mean : weights -> (int -> 'a) -> 'a;
  compare : 'a -> 'a -> int;
  to_rat : 'a -> Rat.t;
}

(* A branch that is certain has the value of its choice. *)
let unless_certain mean w value = if Array.length w.weight = 1 then value 0 else mean w value

let bounded bits x = if Rat.bits x > bits then raise Too_long else x

(* {1 Powers of one denominator} *)

type powers = { n : Z.t; e : int }

let table base =
  let known = Growable.create () in
  Growable.push known Z.one;
  let rec power e =
    if e < Growable.length known then Growable.get known e
    else begin
      Growable.push known (Z.mul base (Growable.get known (Growable.length known - 1)));
      power e
    end
  in
  power

let exact ~base ~bits =
  let power = table base and base_bits = Z.numbits base in
  let raised x e = if Int.equal x.e e then x.n else Z.mul x.n (power (e - x.e)) in
  let to_rat x = Rat.make x.n (power x.e) in
  (* Lengths are bounded in lowest terms, which are looked at only where the terms at hand are too long. *)
  let check x =
    if Z.numbits x.n + (x.e * base_bits) > bits then ignore (bounded bits (to_rat x));
    x
  in
  let mean { weight; sum } value =
    let values = Array.init (Array.length weight) value in
    let e = Array.fold_left (fun e x -> if Z.sign x.n = 0 then e else Int.max e x.e) 0 values in
    let total = ref Z.zero in
    Array.iteri
      (fun i x -> if Z.sign x.n <> 0 then total := Z.add !total (Z.mul weight.(i) (raised x e)))
      values;
    if Z.sign !total = 0 then { n = Z.zero; e = 0 }
    else check { n = (if Z.equal sum base then !total else Z.mul !total (Z.divexact base sum)); e = e + 1 }
  in
  let compare x y =
    let e = Int.max x.e y.e in
    Z.compare (raised x e) (raised y e)
  in
  let integer n = { n; e = 0 } in
  { zero = integer Z.zero; one = integer Z.one; integer; mean = unless_certain mean; compare; to_rat }

(* {1 Fractions} *)

let rational ~bits =
  let mean { weight; sum } value =
    let total = ref Rat.zero in
    Array.iteri (fun i w -> total := Rat.add !total (Rat.mul (Rat.make w sum) (value i))) weight;
    bounded bits !total
  in
  let integer n = Rat.make n Z.one in
  { zero = Rat.zero; one = Rat.one; integer; mean = unless_certain mean; compare = Rat.compare; to_rat = Fun.id }

(* {1 Rounded} *)

type direction = Down | Up

let rounded direction =
  let unit = Z.shift_left Z.one 128 in
  let divide = match direction with Down -> Z.fdiv | Up -> Z.cdiv in
  let mean { weight; sum } value =
    let total = ref Z.zero in
    Array.iteri (fun i w -> total := Z.add !total (Z.mul w (value i))) weight;
    divide !total sum
  in
  {
    zero = Z.zero;
    one = unit;
    integer = Z.mul unit;
    mean = unless_certain mean;
    compare = Z.compare;
    to_rat = (fun n -> Rat.make n unit);
  }

let nothing =
  let to_rat () = Rat.zero in
  { zero = (); one = (); integer = ignore; mean = (fun _ _ -> ()); compare = (fun () () -> 0); to_rat }
