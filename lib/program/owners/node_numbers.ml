type t = { size : int; number : int -> int }

(* Nodes are numbered in 32 bits, with room for two of a kind. *)
let most = 1 lsl 30

let make size number =
  if size >= most then Failure.lost "a limit of resources: formulas on a graph of more than 2^30 states";
  { size; number }

let sum = Array.fold_left ( + ) 0

(* What comes before each of them. *)
let before sizes =
  let total = ref 0 in
  let one size =
    let before = !total in
    total := before + size;
    before
  in
  Array.map one sizes

let by_levels mesh levels =
  let mine = List.init (Levels.count levels) (fun k -> Levels.start levels (k + 1) - Levels.start levels k) in
  let widths = Array.of_list (Mesh.sums mesh mine) in
  let before = before widths in
  make (sum widths) (fun id -> before.(Levels.level levels id) + Levels.rank levels id)

let by_turns mesh part clock ~turns =
  let length = (turns + 7) / 8 in
  let mine = Bytes.make length '\000' in
  for id = 0 to Part.size part - 1 do
    let turn = Clock.turn clock id in
    let byte = Char.code (Bytes.get mine (turn / 8)) in
    Bytes.set mine (turn / 8) (Char.chr (byte lor (1 lsl (turn mod 8))))
  done;
  let mine = Bytes.unsafe_to_string mine in
  let all = Mesh.gather mesh (fun _ -> mine) in
  if Array.exists (fun text -> String.length text <> length) all then
    Failure.refused "an owner: it has other turns";
  let byte k = Array.fold_left (fun bits text -> bits lor Char.code text.[k]) 0 all in
  let rec count bits sum = if bits = 0 then sum else count (bits lsr 1) (sum + (bits land 1)) in
  let ones bits = count bits 0 in
  let bytes = Array.init length byte in
  let counts = Array.map ones bytes in
  let before = before counts in
  let number id =
    let turn = Clock.turn clock id in
    before.(turn / 8) + ones (bytes.(turn / 8) land ((1 lsl (turn mod 8)) - 1))
  in
  make (sum counts) number

let as_they_come mesh part ~home =
  let count = Mesh.count mesh and me = Mesh.number mesh in
  let mine = List.init count (fun owner -> if owner = me then Part.size part else 0) in
  let sizes = Array.of_list (Mesh.sums mesh mine) in
  let place owner = (owner - home + count) mod count in
  let first = sum (Array.mapi (fun owner size -> if place owner < place me then size else 0) sizes) in
  make (sum sizes) (fun id -> first + id)
