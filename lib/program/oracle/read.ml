open Scc_exact

type params = { quotas : Quotas.t; at : Fault.place option; members : (string * Wire.t) list }
type 'a reader = params -> Fault.place -> Wire.t -> 'a

let params quotas members = { quotas; at = None; members }
let quotas p = p.quotas

let within p name : Fault.place =
  match p.at with None -> Member name | Some at -> Within (at, name)

let only p names =
  let known (name, _) =
    if not (List.exists (String.equal name) names) then
      let shown = if String.length name <= 64 then name else "a long name" in
      Fault.invalid (within p shown) "the method knows no such member"
  in
  List.iter known p.members

let rec find name : (string * Wire.t) list -> Wire.t option = function
  | [] -> None
  | (other, v) :: rest -> if String.equal name other then Some v else find name rest

let member p name : Wire.t option =
  match find name p.members with Some Null | None -> None | Some _ as found -> found

let has p name = Option.is_some (member p name)

let required p name (read : 'a reader) =
  match member p name with
  | Some v -> read p (within p name) v
  | None -> Fault.invalid (within p name) "it is missing"

let optional p name (read : 'a reader) = Option.map (read p (within p name)) (member p name)

let value _ _ v = v

let too_long (q : Quotas.t) = Fault.refuse (Limit ("digits", q.digits))

(* Whether an integer has more digits than it may: 2^(bits - 1) <= |z|, and 10^n < 2^(3.33 n). *)
let long (q : Quotas.t) z =
  let bits = Z.numbits z in
  bits > 3 * q.digits && (bits > 4 * q.digits || Z.geq (Z.abs z) (Z.pow (Z.of_int 10) q.digits))

(* Of at most 15 digits, which is nearly every number. *)
let short s =
  let n = String.length s in
  let rec digits i acc =
    if i = n then Some acc
    else
      match String.unsafe_get s i with
      | '0' .. '9' as c -> digits (i + 1) ((10 * acc) + Char.code c - 48)
      | _ -> None
  in
  if n = 0 || n > 15 then None
  else if s.[0] = '-' then if n = 1 then None else Option.map Int.neg (digits 1 0)
  else digits 0 0

let literal p at s =
  match short s with
  | Some n -> Rat.of_int n
  | None ->
    (* Two integers, a point and exponents. *)
    if String.length s > (2 * p.quotas.digits) + 32 then too_long p.quotas
    else (
      match Rat.of_literal s with
      | Ok x ->
        if long p.quotas x.Q.num || long p.quotas x.den then too_long p.quotas;
        x
      | Error Too_large -> too_long p.quotas
      | Error Zero_denominator -> Fault.invalid at "the denominator is zero"
      | Error Malformed -> Fault.invalid at "a number is expected")

let rational p at : Wire.t -> Rat.t = function
  | Number s | Text s -> literal p at s
  | Null | Bool _ | List _ | Object _ -> Fault.invalid at "a number is expected"

let positive p at v =
  let x = rational p at v in
  if Rat.sign x > 0 then x else Fault.invalid at "a positive number is expected"

let not_negative p at v =
  let x = rational p at v in
  if Rat.sign x >= 0 then x else Fault.invalid at "a number that is not negative is expected"

let natural _ at : Wire.t -> int = function
  | Number s when String.length s <= 16 -> (
      match int_of_string_opt s with
      | Some n when n >= 0 && n <= 1 lsl 53 -> n
      | Some _ | None -> Fault.invalid at "a natural number is expected")
  | _ -> Fault.invalid at "a natural number is expected"

let seed _ at : Wire.t -> int64 = function
  | Number s | Text s -> (
      (* OCaml reads 0x1f and 1_0, too. *)
      let decimal = String.for_all (fun c -> c = '-' || (c >= '0' && c <= '9')) s in
      match Int64.of_string_opt s with
      | Some n when decimal && String.length s <= 20 -> n
      | Some _ | None -> Fault.invalid at "an integer of 64 bits is expected")
  | _ -> Fault.invalid at "an integer of 64 bits is expected"

let text _ at : Wire.t -> string = function
  | Text s -> s
  | _ -> Fault.invalid at "a string is expected"

let truth _ at : Wire.t -> bool = function
  | Bool b -> b
  | _ -> Fault.invalid at "true or false is expected"

let vector p at : Wire.t -> Vec.t = function
  | List [ x; y; z ] ->
    Vec.make (rational p (Item (at, 0)) x) (rational p (Item (at, 1)) y) (rational p (Item (at, 2)) z)
  | _ -> Fault.invalid at "an array of three numbers is expected"

let matrix p at : Wire.t -> Mat.t = function
  | List [ x; y; z ] ->
    Mat.make (vector p (Item (at, 0)) x) (vector p (Item (at, 1)) y) (vector p (Item (at, 2)) z)
  | _ -> Fault.invalid at "an array of three vectors is expected"

let quaternion p at : Wire.t -> Quaternion.t = function
  | List [ w; x; y; z ] ->
    let w = rational p (Item (at, 0)) w in
    let v = vector p at (List [ x; y; z ]) in
    if Rat.sign w = 0 && Vec.is_zero v then Fault.invalid at "a quaternion that is not zero is expected"
    else Quaternion.of_rationals w v
  | _ -> Fault.invalid at "an array of four numbers is expected"

let list (read : 'a reader) p at : Wire.t -> 'a list = function
  | List items -> List.mapi (fun i v -> read p (Fault.Item (at, i)) v) items
  | _ -> Fault.invalid at "an array is expected"

let short_list (read : 'a reader) ~limit ~most p at : Wire.t -> 'a list = function
  | List items when List.compare_length_with items most > 0 -> Fault.refuse (Limit (limit, most))
  | v -> list read p at v

let fields p at : Wire.t -> params = function
  | Object members -> { p with at = Some at; members }
  | _ -> Fault.invalid at "an object is expected"

let entries (read : 'a reader) p at : Wire.t -> (string * 'a) list = function
  | Object members ->
    List.map (fun (name, v) -> (name, read p (Fault.Within (at, name)) v)) members
  | _ -> Fault.invalid at "an object is expected"
