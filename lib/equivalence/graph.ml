type t = {
  size : int;
  initial : int;
  labels : string array;
  first : Ints.t;
  label : Ints.t;
  target : Ints.t;
  unknown : Bytes.t;
}

let tau = "tau"
let is_tau label = label = 0
let edges g = Ints.length g.label
let known g s = Bytes.get g.unknown s = '\000'

let complete g = not (Bytes.contains g.unknown '\001')

let iter g s f =
  for e = Ints.get g.first s to Ints.get g.first (s + 1) - 1 do
    f (Ints.get g.label e) (Ints.get g.target e)
  done

let exists g s f =
  let stop = Ints.get g.first (s + 1) in
  let rec from e = e < stop && (f (Ints.get g.label e) (Ints.get g.target e) || from (e + 1)) in
  from (Ints.get g.first s)

type builder = {
  numbers : (string, int) Hashtbl.t;
  mutable names : string list;  (* the last first *)
  from : Ints.buffer;
  by : Ints.buffer;
  into : Ints.buffer;
}

let builder () =
  let numbers = Hashtbl.create 64 in
  Hashtbl.add numbers tau 0;
  {
    numbers;
    names = [ tau ];
    from = Ints.buffer ();
    by = Ints.buffer ();
    into = Ints.buffer ();
  }

let intern b name =
  match Hashtbl.find_opt b.numbers name with
  | Some i -> i
  | None ->
    let i = Hashtbl.length b.numbers in
    Hashtbl.add b.numbers name i;
    b.names <- name :: b.names;
    i

let add b ~source ~label ~target =
  Ints.push b.from source;
  Ints.push b.by label;
  Ints.push b.into target

(* Where each key begins among the items sorted by key: [keys + 1] numbers. *)
let starts ~keys ~items key =
  let first = Ints.make (keys + 1) in
  for i = 0 to items - 1 do
    let k = key i + 1 in
    Ints.set first k (Ints.get first k + 1)
  done;
  for k = 1 to keys do
    Ints.set first k (Ints.get first k + Ints.get first (k - 1))
  done;
  first

(* Codes of labels and targets in the order of the labels. *)
let code label target = (label lsl 31) lor target
let label_of code = code lsr 31
let target_of code = code land Ints.max_value

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

let flags size unknown = Bytes.init size (fun s -> if unknown s then '\001' else '\000')

(* Edges are put to their sources, and sorted there; repetitions leave a gap, which the next ones fill. *)
let finish b ~size ~initial ~unknown =
  let items = Ints.size b.from in
  let labels = Array.of_list (List.rev b.names) in
  let begin_ = starts ~keys:size ~items (Ints.nth b.from) in
  let next = starts ~keys:size ~items (Ints.nth b.from) in
  let label = Ints.make items and target = Ints.make items in
  for e = 0 to items - 1 do
    let s = Ints.nth b.from e in
    let i = Ints.get next s in
    Ints.set label i (Ints.nth b.by e);
    Ints.set target i (Ints.nth b.into e);
    Ints.set next s (i + 1)
  done;
  let codes = ref (Array.make 64 0) and kept = ref 0 in
  let first = Ints.make (size + 1) in
  for s = 0 to size - 1 do
    let from = Ints.get begin_ s in
    let n = Ints.get begin_ (s + 1) - from in
    if n > Array.length !codes then codes := Array.make (2 * n) 0;
    for i = 0 to n - 1 do
      !codes.(i) <- code (Ints.get label (from + i)) (Ints.get target (from + i))
    done;
    sort_codes !codes n;
    for i = 0 to n - 1 do
      let c = !codes.(i) in
      if i = 0 || c <> !codes.(i - 1) then begin
        Ints.set label !kept (label_of c);
        Ints.set target !kept (target_of c);
        incr kept
      end
    done;
    Ints.set first (s + 1) !kept
  done;
  let label = Ints.prefix label !kept and target = Ints.prefix target !kept in
  { size; initial; labels; first; label; target; unknown = flags size unknown }

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
  let number = Ints.make g.size and queue = Ints.buffer () in
  (* 0 stands for not found yet, so the numbers are kept one too high *)
  let find s =
    if Ints.get number s = 0 then begin
      Ints.push queue s;
      Ints.set number s (Ints.size queue)
    end
  in
  find g.initial;
  let b = copy_labels g in
  let next = ref 0 in
  while !next < Ints.size queue do
    iter g (Ints.nth queue !next) (fun label target ->
        find target;
        add b ~source:!next ~label ~target:(Ints.get number target - 1));
    incr next
  done;
  finish b ~size:(Ints.size queue) ~initial:0 ~unknown:(fun i -> is_unknown g (Ints.nth queue i))

let merge g f ~size ~drop_silent_loops =
  let b = copy_labels g in
  let unknown = Bytes.make size '\000' in
  for s = 0 to g.size - 1 do
    let source = f s in
    if is_unknown g s then Bytes.set unknown source '\001';
    iter g s (fun label target ->
        let target = f target in
        if not (drop_silent_loops && is_tau label && source = target) then add b ~source ~label ~target)
  done;
  finish b ~size ~initial:(f g.initial) ~unknown:(fun s -> Bytes.get unknown s = '\001')

type backwards = { begin_ : Ints.t; via : Ints.t; source : Ints.t }

let backwards g =
  let items = edges g in
  let begin_ = starts ~keys:g.size ~items (Ints.get g.target) in
  let next = starts ~keys:g.size ~items (Ints.get g.target) in
  let via = Ints.make items and source = Ints.make items in
  for s = 0 to g.size - 1 do
    iter g s (fun label target ->
        let i = Ints.get next target in
        Ints.set via i label;
        Ints.set source i s;
        Ints.set next target (i + 1))
  done;
  { begin_; via; source }

let sources b s f =
  for i = Ints.get b.begin_ s to Ints.get b.begin_ (s + 1) - 1 do
    f (Ints.get b.via i) (Ints.get b.source i)
  done
