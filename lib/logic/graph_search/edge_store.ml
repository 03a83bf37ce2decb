open Scc_data

(* The edges of a state stand side by side, after their number. *)
type t = { first : Int_vector.t;  (** -1 for none *) labels : Int_vector.t; targets : Int_vector.t }

let create () =
  { first = Int_vector.create (); labels = Int_vector.create (); targets = Int_vector.create () }

let make_room s = Int_vector.push s.first (-1)

let push s label target =
  Int_vector.push s.labels label;
  Int_vector.push s.targets target

let set s i ~labels ~targets =
  Int_vector.set s.first i (Int_vector.length s.targets);
  push s 0 (Array.length targets);
  Array.iter2 (push s) labels targets

let get s i edge =
  match Int_vector.get s.first i with
  | -1 -> [||]
  | at ->
    Array.init (Int_vector.get s.targets at) (fun n ->
        edge (Int_vector.get s.labels (at + n + 1)) (Int_vector.get s.targets (at + n + 1)))

let targets s i test =
  match Int_vector.get s.first i with
  | -1 -> [||]
  | at ->
    let last = at + Int_vector.get s.targets at in
    let rec count k n =
      if k > last then n else count (k + 1) (if test (Int_vector.get s.labels k) then n + 1 else n)
    in
    let found = Array.make (count (at + 1) 0) 0 in
    let rec fill k n =
      if k <= last then
        if test (Int_vector.get s.labels k) then begin
          found.(n) <- Int_vector.get s.targets k;
          fill (k + 1) (n + 1)
        end
        else fill (k + 1) n
    in
    fill (at + 1) 0;
    found

let find_label s i test =
  match Int_vector.get s.first i with
  | -1 -> None
  | at ->
    let last = at + Int_vector.get s.targets at in
    let rec from k =
      if k > last then None
      else
        let label = Int_vector.get s.labels k in
        if test label then Some label else from (k + 1)
    in
    from (at + 1)

let bytes s = Int_vector.bytes s.first + Int_vector.bytes s.labels + Int_vector.bytes s.targets
