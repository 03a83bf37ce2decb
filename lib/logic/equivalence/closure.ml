open Scc_data

type t = {
  effort : Effort.t;
  g : Graph.t;
  back : Graph.backwards;
  seen : int array;  (* the search that saw the state last *)
  mutable search : int;
  silent : Int_array.buffer;  (* what tau* reaches *)
  found : Int_array.buffer;  (* the states of the search under way, in order *)
}

let make effort (g : Graph.t) back =
  {
    effort;
    g;
    back;
    seen = Array.make g.size 0;
    search = 0;
    silent = Int_array.buffer ();
    found = Int_array.buffer ();
  }

let start c = c.search <- c.search + 1

let visit c states s =
  if c.seen.(s) <> c.search then begin
    c.seen.(s) <- c.search;
    Int_array.push states s
  end

(* Completes [states] under an expansion. *)
let close c states expand =
  let next = ref 0 in
  while !next < Int_array.size states do
    Effort.spend c.effort 1;
    expand (Int_array.nth states !next);
    incr next
  done

let silent_steps c states s =
  Graph.iter c.g s (fun label target -> if Graph.is_tau label then visit c states target)

let weak_steps c s f =
  start c;
  Int_array.clear c.silent;
  visit c c.silent s;
  close c c.silent (silent_steps c c.silent);
  let steps = ref [] in
  for i = 0 to Int_array.size c.silent - 1 do
    let s = Int_array.nth c.silent i in
    f 0 s;
    Graph.iter c.g s (fun label target ->
        if not (Graph.is_tau label) then steps := (label, target) :: !steps)
  done;
  (* the steps of one label are one search *)
  let flush label =
    close c c.found (silent_steps c c.found);
    for i = 0 to Int_array.size c.found - 1 do
      f label (Int_array.nth c.found i)
    done
  in
  let last =
    List.fold_left
      (fun last (label, target) ->
         if label <> last then begin
           if last > 0 then flush last;
           start c;
           Int_array.clear c.found
         end;
         visit c c.found target;
         label)
      0
      (List.stable_sort (fun (a, _) (b, _) -> Int.compare a b) !steps)
  in
  if last > 0 then flush last

let weak_sources c states f =
  let silent_sources into s =
    Graph.sources c.back s (fun label source -> if Graph.is_tau label then visit c into source)
  in
  start c;
  Int_array.clear c.silent;
  List.iter (visit c c.silent) states;
  close c c.silent (silent_sources c.silent);
  start c;
  Int_array.clear c.found;
  for i = 0 to Int_array.size c.silent - 1 do
    (* by tau* alone, or by an action that tau* may follow and go before *)
    let s = Int_array.nth c.silent i in
    visit c c.found s;
    Graph.sources c.back s (fun _ source -> visit c c.found source)
  done;
  close c c.found (silent_sources c.found);
  for i = 0 to Int_array.size c.found - 1 do
    f (Int_array.nth c.found i)
  done
