open Scc_codec

type event = { rank : int; ahead : bool; choice : int; owner : int; id : int }
type place = { level : int; owner : int; id : int }
type stop = Early | States | Levels | Late

type t = {
  level : int;
  depth : int;
  width : int;
  states : int;
  transitions : int;
  met : place option array;
  doubts : bool array;
  open_ : bool array option;
  stop : stop option;
  faults : string list;
  ends : string list;
  too_long : int;
  too_deep : int;
}

let stops = [ ("early", Early); ("states", States); ("levels", Levels); ("late", Late) ]
let stop_name s = fst (List.find (fun (_, x) -> x = s) stops)

let compare_events (a : event) (b : event) =
  Int.compare a.rank b.rank <?> fun () ->
    Bool.compare a.ahead b.ahead <?> fun () -> Int.compare a.choice b.choice

let earlier a b = Option.merge (fun a b -> if compare_events b a < 0 then b else a) a b

let least_looked_at = 100

let is_time_to_look ~before p =
  let rec doubled k = if k > before.states then k else doubled (2 * k) in
  p.stop = None && Array.for_all Option.is_some p.met && doubled least_looked_at <= p.states

let add texts more = List.sort_uniq String.compare (more @ texts)

(* {1 As bytes} *)

let put_texts b texts =
  Packed.put_list b
    (fun b t ->
       Packed.put_nat b (String.length t);
       Buffer.add_string b t)
    texts

let put_array b put array = Packed.put_list b put (Array.to_list array)

let put_option b put = function
  | None -> Packed.put_nat b 0
  | Some x ->
    Packed.put_nat b 1;
    put b x

let read_option s read = if Packed.below 2 ~what:"an option" s = 0 then None else Some (read s)
let put_bool b x = Packed.put_nat b (Bool.to_int x)
let read_bool s = Packed.below 2 ~what:"a truth" s = 1

let put b p =
  List.iter (Packed.put_nat b) [ p.level; p.depth; p.width; p.states; p.transitions; p.too_long; p.too_deep ];
  let place b (x : place) = List.iter (Packed.put_nat b) [ x.level; x.owner; x.id ] in
  put_array b (fun b -> put_option b place) p.met;
  put_array b put_bool p.doubts;
  put_texts b p.faults;
  put_texts b p.ends

let read s =
  let level = Packed.nat s in
  let depth = Packed.nat s in
  let width = Packed.nat s in
  let states = Packed.nat s in
  let transitions = Packed.nat s in
  let too_long = Packed.nat s in
  let too_deep = Packed.nat s in
  let place s =
    let level = Packed.nat s in
    let owner = Packed.nat s in
    { level; owner; id = Packed.nat s }
  in
  let met = Array.of_list (Packed.list s (fun s -> read_option s place)) in
  let doubts = Array.of_list (Packed.list s read_bool) in
  let faults = Packed.list s Packed.text in
  let ends = Packed.list s Packed.text in
  {
    level; depth; width; states; transitions; met; doubts; faults; ends; too_long; too_deep;
    open_ = None; stop = None;
  }
