open Scc_exact
open Scc_calculus

let greatest = 24

let rat q =
  let text = Rat.to_string q in
  if String.length text <= greatest then text else Decimal.marked q

(* What nobody would read to the end. *)
let endless = 60

(* A fraction of which one does not see how great it is. *)
let plain_fraction = 15

let exact q =
  let text = Rat.to_string q in
  let length = String.length text in
  if length > endless then Printf.sprintf "%s (%d characters)" (Decimal.marked q) length
  else if length > plain_fraction && not (Rat.is_integer q) then Printf.sprintf "%s (%s)" text (Decimal.marked q)
  else text

let is_digit c = c >= '0' && c <= '9'

(* The end of the number that begins at an index: digits, and a fraction's other digits. *)
let end_of_number s i =
  let rec digits i = if i < String.length s && is_digit s.[i] then digits (i + 1) else i in
  let j = digits i in
  if j + 1 < String.length s && s.[j] = '/' && is_digit s.[j + 1] then digits (j + 1) else j

let within s =
  let b = Buffer.create (String.length s) in
  let rec go i =
    if i < String.length s then
      if not (is_digit s.[i]) then begin
        Buffer.add_char b s.[i];
        go (i + 1)
      end
      else begin
        let j = end_of_number s i in
        let text = String.sub s i (j - i) in
        let decimal = i > 0 && s.[i - 1] = '.' in
        Buffer.add_string b (if decimal || j - i <= plain_fraction then text else exact (Q.of_string text));
        go j
      end
  in
  go 0;
  Buffer.contents b

let vec ~full (m : Model.t) (v : Vec.t) =
  let number = if full then Rat.to_string else if Option.is_none m.rigid then exact else rat in
  Printf.sprintf "(%s, %s, %s)" (number v.x) (number v.y) (number v.z)

(* In proportion to w + |x| + |y| + |z| = 1 where the integers are long. *)
let quaternion ~full (q : Quaternion.t) =
  let text = Quaternion.to_string q in
  if full || String.length text <= 2 * greatest then text
  else
    let size = List.fold_left (fun s z -> Z.add s (Z.abs z)) Z.zero [ q.w; q.x; q.y; q.z ] in
    let share z = Decimal.padded ~places:6 (Rat.make z size) in
    Printf.sprintf "~(%s, %s, %s, %s)" (share q.w) (share q.x) (share q.y) (share q.z)

let position ?(full = false) m (l : State.leaf) =
  let place = vec ~full m l.position in
  if Quaternion.is_identity l.turned then place else place ^ " turned " ^ quaternion ~full l.turned

let motion ?(full = false) m (p : State.process) =
  let velocity = "velocity " ^ vec ~full m p.velocity in
  if Vec.is_zero p.spin then velocity else velocity ^ ", spin " ^ vec ~full m p.spin

let bond m (b : State.bond) =
  let site (f : State.finish) = Model.site_name m ~leaf:f.at f.site in
  Printf.sprintf "<%s, {%s, %s}>" b.name (site b.one) (site b.two)
