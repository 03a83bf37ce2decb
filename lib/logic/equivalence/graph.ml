open Scc_data

type t = {
  size : int;
  initial : int;
  labels : string array;
  first : Int_array.t;
  label : Int_array.t;
  target : Int_array.t;
  unknown : Bits.t;
}

let tau = "tau"
let is_tau label = label = 0
let edges g = Int_array.length g.label
let known g s = not (Bits.mem g.unknown s)

let complete g = Bits.is_empty g.unknown

let iter g s f =
  for e = Int_array.get g.first s to Int_array.get g.first (s + 1) - 1 do
    f (Int_array.get g.label e) (Int_array.get g.target e)
  done

let exists g s f =
  let stop = Int_array.get g.first (s + 1) in
  let rec from e = e < stop && (f (Int_array.get g.label e) (Int_array.get g.target e) || from (e + 1)) in
  from (Int_array.get g.first s)

module Names = Numbering.Make (struct
    include String

    let hash (name : string) = Hashtbl.hash name
  end)

type builder = {
  names : Names.t;
  from : Int_array.buffer;
  by : Int_array.buffer;
  into : Int_array.buffer;
}

let builder () =
  let names = Names.create () in
  ignore (Names.number names tau);
  { names; from = Int_array.buffer (); by = Int_array.buffer (); into = Int_array.buffer () }

let intern b = Names.number b.names

let add b ~source ~label ~target =
  Int_array.push b.from source;
  Int_array.push b.by label;
  Int_array.push b.into target

(* Where each key begins among the items sorted by key: [keys + 1] numbers. *)
let starts ~keys ~items key =
  let first = Int_array.make (keys + 1) 0 in
  for i = 0 to items - 1 do
    let k = key i + 1 in
    Int_array.set first k (Int_array.get first k + 1)
  done;
  for k = 1 to keys do
    Int_array.set first k (Int_array.get first k + Int_array.get first (k - 1))
  done;
  first

(* Codes of labels and targets in the order of the labels. *)
let code label target = (label lsl 31) lor target
let label_of code = code lsr 31
let target_of code = code land Int_array.max_value

(* Sorts [n] codes; most states have few edges. *)
let sort_codes codes n =
  if n > 32 then begin
    let part = Array.sub codes 0 n in
    Array.stable_sort Int.compare part;
    Array.blit part 0 codes 0 n
  end
  else
    for i = 1 to n - 1 do
      let x = codes.(i) in
      let j = ref (i - 1) in
      while !j >= 0 && codes.(!j) > x do
        codes.(!j + 1) <- codes.(!j);
        decr j
      done;
      codes.(!j + 1) <- x
    done

(* Edges are put to their sources, and sorted there; repetitions leave a gap, which the next ones fill. *)
let finish b ~size ~initial ~unknown =
  let items = Int_array.size b.from in
  let labels = Array.of_list (Names.keys b.names) in
  let begin_ = starts ~keys:size ~items (Int_array.nth b.from) in
  let next = starts ~keys:size ~items (Int_array.nth b.from) in
  let label = Int_array.make items 0 and target = Int_array.make items 0 in
  for e = 0 to items - 1 do
    let s = Int_array.nth b.from e in
    let i = Int_array.get next s in
    Int_array.set label i (Int_array.nth b.by e);
    Int_array.set target i (Int_array.nth b.into e);
    Int_array.set next s (i + 1)
  done;
  let codes = ref (Array.make 64 0) and kept = ref 0 in
  let first = Int_array.make (size + 1) 0 in
  for s = 0 to size - 1 do
    let from = Int_array.get begin_ s in
    let n = Int_array.get begin_ (s + 1) - from in
    if n > Array.length !codes then codes := Array.make (2 * n) 0;
    for i = 0 to n - 1 do
      !codes.(i) <- code (Int_array.get label (from + i)) (Int_array.get target (from + i))
    done;
    sort_codes !codes n;
    for i = 0 to n - 1 do
      let c = !codes.(i) in
      if i = 0 || c <> !codes.(i - 1) then begin
        Int_array.set label !kept (label_of c);
        Int_array.set target !kept (target_of c);
        incr kept
      end
    done;
    Int_array.set first (s + 1) !kept
  done;
  let label = Int_array.prefix label !kept and target = Int_array.prefix target !kept in
  { size; initial; labels; first; label; target; unknown = Bits.init size unknown }

let is_unknown g s = not (known g s)

let map_labels g f =
  let b = builder () in
  let number = Array.mapi (fun i name -> if is_tau i then 0 else intern b (f name)) g.labels in
  for s = 0 to g.size - 1 do
    iter g s (fun label target -> add b ~source:s ~label:number.(label) ~target)
  done;
  finish b ~size:g.size ~initial:g.initial ~unknown:(is_unknown g)

let union g h =
  let b = builder () in
  let copy offset g =
    let number = Array.map (intern b) g.labels in
    for s = 0 to g.size - 1 do
      iter g s (fun label target ->
          add b ~source:(offset + s) ~label:number.(label) ~target:(offset + target))
    done
  in
  copy 0 g;
  copy g.size h;
  let unknown s = if s < g.size then is_unknown g s else is_unknown h (s - g.size) in
  (finish b ~size:(g.size + h.size) ~initial:g.initial ~unknown, g.size + h.initial)

let copy_labels g =
  let b = builder () in
  Array.iter (fun name -> ignore (intern b name)) g.labels;
  b

let reachable g =
  let number = Int_array.make g.size 0 and queue = Int_array.buffer () in
  (* 0 stands for not found yet, so the numbers are kept one too high *)
  let find s =
    if Int_array.get number s = 0 then begin
      Int_array.push queue s;
      Int_array.set number s (Int_array.size queue)
    end
  in
  find g.initial;
  let b = copy_labels g in
  let next = ref 0 in
  while !next < Int_array.size queue do
    iter g (Int_array.nth queue !next) (fun label target ->
        find target;
        add b ~source:!next ~label ~target:(Int_array.get number target - 1));
    incr next
  done;
  finish b ~size:(Int_array.size queue) ~initial:0 ~unknown:(fun i -> is_unknown g (Int_array.nth queue i))

let merge g f ~size ~drop_silent_loops =
  let b = copy_labels g in
  let unknown = Bits.create size in
  for s = 0 to g.size - 1 do
    let source = f s in
    if is_unknown g s then Bits.add unknown source;
    iter g s (fun label target ->
        let target = f target in
        if not (drop_silent_loops && is_tau label && source = target) then add b ~source ~label ~target)
  done;
  finish b ~size ~initial:(f g.initial) ~unknown:(Bits.mem unknown)

type backwards = { begin_ : Int_array.t; via : Int_array.t; source : Int_array.t }

let backwards g =
  let items = edges g in
  let begin_ = starts ~keys:g.size ~items (Int_array.get g.target) in
  let next = starts ~keys:g.size ~items (Int_array.get g.target) in
  let via = Int_array.make items 0 and source = Int_array.make items 0 in
  for s = 0 to g.size - 1 do
    iter g s (fun label target ->
        let i = Int_array.get next target in
        Int_array.set via i label;
        Int_array.set source i s;
        Int_array.set next target (i + 1))
  done;
  { begin_; via; source }

let sources b s f =
  for i = Int_array.get b.begin_ s to Int_array.get b.begin_ (s + 1) - 1 do
    f (Int_array.get b.via i) (Int_array.get b.source i)
  done
