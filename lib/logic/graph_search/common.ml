open Scc_data

(* A text is a list of pairs: each of the number of the list before it, plus one, and of some of its bytes. The
   list and the kind of thing that it names are a pair again, in another table, whose numbers are few. *)
type t = { lists : Pairs.t; names : Pairs.t; first : int  (** the number of the first name *) }

type numbers = {
  mutable shared : t option;
  mutable kind : int;
  mutable base : int;  (** own numbers below it are common ones *)
  common : int Growable.t;  (** of own numbers from [base] on; -1 where that is not known *)
  own : (int, int) Hashtbl.t;
}

let numbers () =
  { shared = None; kind = 0; base = max_int; common = Growable.create (); own = Hashtbl.create 16 }

let create ~first =
  let lists = Pairs.create ~in_files:false and names = Pairs.create ~in_files:false in
  if Pairs.share lists ~many:true && Pairs.share names ~many:true then Some { lists; names; first } else None

let share n t ~kind ~base =
  n.shared <- Some t;
  n.kind <- kind;
  n.base <- base

(** {2 Texts} *)

let bytes_at_once = 3

(* The bytes, behind a 1 that tells how many they are. *)
let piece text at =
  let count = Int.min bytes_at_once (String.length text - at) in
  let rec from k number =
    if k = count then number else from (k + 1) ((number lsl 8) lor Char.code text.[at + k])
  in
  from 0 1

let intern t ~kind text =
  let rec from at list =
    if at >= String.length text then list
    else from (at + bytes_at_once) (1 + Pairs.intern t.lists list (piece text at))
  in
  t.first + Pairs.intern t.names (from 0 0) kind

let text t number =
  let rec before list pieces =
    if list = 0 then pieces else before (Pairs.left t.lists (list - 1)) (Pairs.right t.lists (list - 1) :: pieces)
  in
  let buffer = Buffer.create 64 in
  let add piece =
    let count = if piece lsr 24 > 0 then 3 else if piece lsr 16 > 0 then 2 else 1 in
    for k = count - 1 downto 0 do Buffer.add_char buffer (Char.unsafe_chr ((piece lsr (8 * k)) land 255)) done
  in
  List.iter add (before (Pairs.left t.names (number - t.first)) []);
  Buffer.contents buffer

(** {2 Numbers} *)

let note n ~own number =
  let at = own - n.base in
  while Growable.length n.common <= at do
    Growable.push n.common (-1)
  done;
  Growable.set n.common at number;
  Hashtbl.replace n.own number own

let known n own =
  let at = own - n.base in
  if at < Growable.length n.common then Growable.get n.common at else -1

let find_common n own name =
  match (known n own, n.shared) with
  | -1, Some t ->
    let number = intern t ~kind:n.kind (name own) in
    Scc_base.Critical.run (fun () -> note n ~own number);
    number
  | number, _ -> number

let[@inline] common n own name = if own < n.base then own else find_common n own name

let find_own n number make =
  match (Hashtbl.find_opt n.own number, n.shared) with
  | Some own, _ -> own
  | None, Some t ->
    let own = make (text t number) in
    (* What has been made may have been known, by this number. *)
    Scc_base.Critical.run (fun () -> note n ~own number);
    own
  | None, None -> Scc_base.Bug.fail __POS__ "a number of nothing"

let[@inline] own n number make = if number < n.base then number else find_own n number make

(** {2 Several processes} *)

let tables t = [ t.lists; t.names ]
let refresh t = List.iter Pairs.refresh (tables t)
let is_room_wanted t = List.exists Pairs.is_room_wanted (tables t)
let make_room t = List.iter Pairs.enlarge_shared (List.filter Pairs.is_room_wanted (tables t))
let set_full t full = List.iter (fun p -> Pairs.set_full p full) (tables t)
let go_on_apart t ~full = List.iter (fun p -> Pairs.go_on_apart p ~full) (tables t)
