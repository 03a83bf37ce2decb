let is_letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
let is_digit c = c >= '0' && c <= '9'

let plain label =
  let mapped = String.map (fun c -> if is_letter c || is_digit c then c else '_') label in
  match String.lowercase_ascii label with
  | "" | "default" | "(null)" -> None
  | _ when is_letter mapped.[0] -> Some mapped
  | _ -> Some ("g" ^ mapped)

(* How many faces each label has. *)
let count labels =
  let table = Hashtbl.create 16 in
  let add (l : string) = Hashtbl.replace table l (1 + Option.value (Hashtbl.find_opt table l) ~default:0) in
  Array.iter (Option.iter add) labels;
  table

let numbered label k =
  let last = label.[String.length label - 1] in
  Printf.sprintf (if is_digit last then "%s_%d" else "%s%d") label k

let names ~vertices labels =
  let labels = Array.map (fun l -> Option.bind l plain) labels in
  let counts = count labels in
  let n = Array.length labels in
  let says_nothing = Hashtbl.fold (fun _ k all -> all || k = n) counts false && n > 1 in
  let taken = Hashtbl.create 64 in
  Array.iter (fun v -> Hashtbl.replace taken v ()) vertices;
  let take name =
    if Hashtbl.mem taken name then None
    else begin
      Hashtbl.replace taken name ();
      Some name
    end
  in
  let found = Array.make n None in
  let each test name =
    let one f = function Some l when test l -> found.(f) <- take (name l) | Some _ | None -> () in
    Array.iteri one labels
  in
  if not says_nothing then begin
    let so_far = Hashtbl.create 16 in
    let next l =
      let k = Option.value (Hashtbl.find_opt so_far l) ~default:0 in
      Hashtbl.replace so_far l (k + 1);
      numbered l k
    in
    let alone l = Hashtbl.find counts l = 1 and is_reserved = Scc_base.Language_words.is_reserved in
    each (fun l -> alone l && not (is_reserved l)) Fun.id;
    each (fun l -> alone l && is_reserved l) (fun l -> "g" ^ l);
    each (fun l -> not (alone l)) next
  end;
  let rec free name = match take name with Some name -> name | None -> free (name ^ "_") in
  Array.mapi (fun f -> function Some name -> name | None -> free (Printf.sprintf "f%d" f)) found
