type 'a t = {
  prefix : string;
  limit : string;
  most : int;
  table : (string, 'a) Hashtbl.t;
  mutable made : int;
}

let create ~prefix ~limit ~most = { prefix; limit; most; table = Hashtbl.create 64; made = 0 }

let check_room h = if Hashtbl.length h.table >= h.most then Fault.refuse (Limit (h.limit, h.most))

let add h x =
  h.made <- h.made + 1;
  let handle = h.prefix ^ string_of_int h.made in
  Hashtbl.replace h.table handle x;
  handle

let shown handle = if String.length handle <= 64 then handle else "a long handle"

let get h handle =
  match Hashtbl.find_opt h.table handle with
  | Some x -> x
  | None -> Fault.refuse (Unknown_handle (shown handle))

let find h p at v = get h (Read.text p at v)

let release h handle =
  let x = get h handle in
  Hashtbl.remove h.table handle;
  x

let iter f h = Hashtbl.iter (fun _ x -> f x) h.table
