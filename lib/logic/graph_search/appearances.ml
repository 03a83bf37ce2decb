type family = {
  mutable appeared : int array;  (** of the number of the process; -1 for none *)
  mutable number : int array;  (** of the process, of the number by appearance *)
  mutable size : int;
}

type t = { families : family list; of_slot : family array }

let create ~width ~family =
  let known : (int, family) Hashtbl.t = Hashtbl.create 8 in
  let of_slot slot =
    match Hashtbl.find_opt known (family slot) with
    | Some f -> f
    | None ->
      let f = { appeared = [||]; number = [||]; size = 0 } in
      Hashtbl.replace known (family slot) f;
      f
  in
  let of_slot = Array.init width of_slot in
  { families = Hashtbl.fold (fun _ f l -> f :: l) known []; of_slot }

let longer array length =
  let more = Array.make (Int.max 64 (2 * length)) (-1) in
  Array.blit array 0 more 0 (Array.length array);
  more

let appear f number =
  if number >= Array.length f.appeared then f.appeared <- longer f.appeared (number + 1);
  if f.size >= Array.length f.number then f.number <- longer f.number (f.size + 1);
  f.appeared.(number) <- f.size;
  f.number.(f.size) <- number;
  f.size <- f.size + 1;
  f.size - 1

let appeared f number =
  let known = if number < Array.length f.appeared then f.appeared.(number) else -1 in
  if known >= 0 then known else appear f number

let changes t changes =
  let one i x = if i land 1 = 0 then x else appeared t.of_slot.(changes.(i - 1)) x in
  Array.mapi one changes

let tuple t numbers = Array.mapi (fun slot k -> t.of_slot.(slot).number.(k)) numbers
let bytes t = List.fold_left (fun n f -> n + (8 * (Array.length f.appeared + Array.length f.number))) 0 t.families
