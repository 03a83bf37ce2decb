open Scc_exact
open Scc_json

type params = { quotas : Quotas.t; at : Fault.place option; members : (string * Wire.t) list }

type 'a reader = { schema : Json_schema.t; value : params -> Fault.place -> Wire.t -> 'a }
type 'a member = { name : string; about : string option; reader : 'a reader }

let params quotas members = { quotas; at = None; members }
let quotas p = p.quotas

let within p name : Fault.place =
  match p.at with None -> Member name | Some at -> Within (at, name)

let file = "oracle"
let defined name t = Json_schema.Reference { file; name; target = lazy t }
let reader schema value = { schema; value }
let member ?about name reader = { name; about; reader }

let listed required m : Json_schema.member =
  let value = m.reader.schema in
  let value = match m.about with None -> value | Some text -> Json_schema.About (text, value) in
  { name = m.name; required; value }

let needs m = listed true m
let may m = listed false m

let only p members =
  let known (name, _) =
    if not (List.exists (fun (m : Json_schema.member) -> String.equal name m.name) members) then
      let shown = if String.length name <= 64 then name else "a long name" in
      Fault.invalid (within p shown) "the method knows no such member"
  in
  List.iter known p.members

let rec find name : (string * Wire.t) list -> Wire.t option = function
  | [] -> None
  | (other, v) :: rest -> if String.equal name other then Some v else find name rest

let given p name : Wire.t option =
  match find name p.members with Some Null | None -> None | Some _ as found -> found

let has p (m : Json_schema.member) = Option.is_some (given p m.name)
let place p m = within p m.name

let required p m =
  match given p m.name with
  | Some v -> m.reader.value p (place p m) v
  | None -> Fault.invalid (place p m) "it is missing"

let optional p m = Option.map (m.reader.value p (place p m)) (given p m.name)
let value schema = reader schema (fun _ _ v -> v)

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

let number =
  let pattern = "^[+-]?[0-9]+(\\.[0-9]+)?([eE][+-]?[0-9]+)?(/[0-9]+(\\.[0-9]+)?([eE][+-]?[0-9]+)?)?$" in
  let alternatives =
    [
      Json_schema.Also ([ ("type", `String "number") ], Anything);
      Also ([ ("pattern", `String pattern) ], Text { least = 0 });
    ]
  in
  defined "number"
    (About
       ("An exact number in a request: p/q, a decimal, or a JSON number taken as written.", Any_of alternatives))

let rational =
  reader number (fun p at -> function
      | Number s | Text s -> literal p at s
      | Null | Bool _ | List _ | Object _ -> Fault.invalid at "a number is expected")

let checked holds why =
  reader number (fun p at v ->
      let x = rational.value p at v in
      if holds (Rat.sign x) then x else Fault.invalid at "%s" why)

let positive = checked (fun sign -> sign > 0) "a positive number is expected"
let not_negative = checked (fun sign -> sign >= 0) "a number that is not negative is expected"

let natural =
  reader (Integer { least = Some 0; most = None }) (fun _ at -> function
      | Number s when String.length s <= 16 -> (
          match int_of_string_opt s with
          | Some n when n >= 0 && n <= 1 lsl 53 -> n
          | Some _ | None -> Fault.invalid at "a natural number is expected")
      | _ -> Fault.invalid at "a natural number is expected")

let seed =
  let text = Json_format.schema Scc_runs.Shared.seed in
  let schema = Json_schema.Any_of [ Integer { least = None; most = None }; text ] in
  reader schema (fun _ at -> function
      | Number s | Text s -> (
          (* OCaml reads 0x1f and 1_0, too. *)
          let decimal = String.for_all (fun c -> c = '-' || (c >= '0' && c <= '9')) s in
          match Int64.of_string_opt s with
          | Some n when decimal && String.length s <= 20 -> n
          | Some _ | None -> Fault.invalid at "an integer of 64 bits is expected")
      | _ -> Fault.invalid at "an integer of 64 bits is expected")

let text =
  reader (Text { least = 0 }) (fun _ at -> function Text s -> s | _ -> Fault.invalid at "a string is expected")

let truth = reader Bool (fun _ at -> function Bool b -> b | _ -> Fault.invalid at "true or false is expected")

let of_so_many each count = Json_schema.Items { each; least = count; most = Some count; distinct = false }

let vector =
  reader (defined "vector" (of_so_many number 3)) (fun p at -> function
      | List [ x; y; z ] ->
        let part i = rational.value p (Item (at, i)) in
        Vec.make (part 0 x) (part 1 y) (part 2 z)
      | _ -> Fault.invalid at "an array of three numbers is expected")

let matrix =
  reader (defined "matrix" (of_so_many vector.schema 3)) (fun p at -> function
      | List [ x; y; z ] ->
        let row i = vector.value p (Item (at, i)) in
        Mat.make (row 0 x) (row 1 y) (row 2 z)
      | _ -> Fault.invalid at "an array of three vectors is expected")

let quaternion =
  let schema = defined "quaternion" (About ("w, x, y, z, not all zero.", of_so_many number 4)) in
  reader schema (fun p at -> function
      | List [ w; x; y; z ] ->
        let w = rational.value p (Item (at, 0)) w in
        let v = vector.value p at (List [ x; y; z ]) in
        if Rat.sign w = 0 && Vec.is_zero v then Fault.invalid at "a quaternion that is not zero is expected"
        else Quaternion.of_rationals w v
      | _ -> Fault.invalid at "an array of four numbers is expected")

let list ?(least = 0) r =
  reader (Items { each = r.schema; least; most = None; distinct = false }) (fun p at -> function
      | List items -> List.mapi (fun i v -> r.value p (Fault.Item (at, i)) v) items
      | _ -> Fault.invalid at "an array is expected")

let short_list r ~limit most =
  let whole = list r in
  reader whole.schema (fun p at -> function
      | List items when List.compare_length_with items (most p.quotas) > 0 ->
        Fault.refuse (Limit (limit, most p.quotas))
      | v -> whole.value p at v)

let any_fields =
  reader (Entries Anything) (fun p at -> function
      | Object members -> { p with at = Some at; members }
      | _ -> Fault.invalid at "an object is expected")

let entries r =
  reader (Entries r.schema) (fun p at -> function
      | Object members ->
        List.map (fun (name, v) -> (name, r.value p (Fault.Within (at, name)) v)) members
      | _ -> Fault.invalid at "an object is expected")

let map f r = { r with value = (fun p at v -> f p at (r.value p at v)) }

let fields members =
  let closed _ _ p = only p members; p in
  { (map closed any_fields) with schema = Members members }

let required_as r p m = r.value p (place p m) (required p m)
