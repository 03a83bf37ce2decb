open Bigarray

type cells = (int32, int32_elt, c_layout) Array1.t

(* Chunks of [span] numbers. One whose numbers are all equal has no cells, but stands for that number. *)
type t = { mutable chunks : cells array; mutable common : int array; mutable length : int }

let bits = 12
let span = 1 lsl bits
let no_cells : cells = Array1.create int32 c_layout 0
let create () = { chunks = [||]; common = [||]; length = 0 }
let length v = v.length

let check v i = if i < 0 || i >= v.length then Scc_base.Bug.fail __POS__ "an index out of range"

let get v i =
  check v i;
  let cells : cells = Array.unsafe_get v.chunks (i lsr bits) in
  if Array1.dim cells = 0 then v.common.(i lsr bits)
  else Int32.to_int (Array1.unsafe_get cells (i land (span - 1)))

let fits x = x >= -0x8000_0000 && x <= 0x7fff_ffff

(* The cells of a chunk, which may have to be made. *)
let cells_of v k : cells =
  let cells = v.chunks.(k) in
  if Array1.dim cells > 0 then cells
  else begin
    let cells = Array1.create int32 c_layout span in
    Array1.fill cells (Int32.of_int v.common.(k));
    v.chunks.(k) <- cells;
    cells
  end

let set v i x =
  check v i;
  if not (fits x) then Scc_base.Bug.fail __POS__ "a number that is too great";
  let k = i lsr bits in
  if Array1.dim v.chunks.(k) > 0 || v.common.(k) <> x then
    Array1.set (cells_of v k) (i land (span - 1)) (Int32.of_int x)

let make_room v x =
  let k = v.length lsr bits in
  if k = Array.length v.chunks then begin
    let more = Int.max 8 k in
    v.chunks <- Array.append v.chunks (Array.make more no_cells);
    v.common <- Array.append v.common (Array.make more 0)
  end;
  v.common.(k) <- x

let push v x =
  if v.length land (span - 1) = 0 then make_room v x;
  v.length <- v.length + 1;
  set v (v.length - 1) x

let bytes v =
  Array.fold_left (fun n cells -> n + (4 * Array1.dim cells)) (16 * Array.length v.chunks) v.chunks
