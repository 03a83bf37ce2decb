module Table = Map.Make (String)

(* A request may be given up at any instant: a map is replaced as a whole, or not. *)
type 'a t = {
  prefix : string;
  limit : string;
  most : int;
  mutable table : 'a Table.t;
  mutable count : int;
  mutable made : int;
}

let create ~prefix ~limit ~most = { prefix; limit; most; table = Table.empty; count = 0; made = 0 }

let set h table =
  let count = Table.cardinal table in
  h.table <- table;
  h.count <- count

let check_room h = if h.count >= h.most then Fault.refuse (Limit (h.limit, h.most))

let add h x =
  let made = h.made + 1 in
  let handle = h.prefix ^ string_of_int made in
  let table = Table.add handle x h.table in
  h.made <- made;
  set h table;
  handle

let shown handle = if String.length handle <= 64 then handle else "a long handle"

let get h handle =
  match Table.find_opt handle h.table with
  | Some x -> x
  | None -> Fault.refuse (Unknown_handle (shown handle))

let release h handle =
  let x = get h handle in
  set h (Table.remove handle h.table);
  x

let iter f h = Table.iter (fun _ x -> f x) h.table
