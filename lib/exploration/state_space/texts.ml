open Scc_codec

let bytes put =
  let buffer = Buffer.create 64 in
  put buffer;
  Buffer.contents buffer

let reading text read =
  let source = Packed.source text in
  match
    let x = read source in
    if Packed.at_end source then x else failwith "there is more than was to be read"
  with
  | x -> x
  | exception Packed.Malformed what -> failwith what

(* 0 and the label, and its chance if that is not its own; or the number of joined draws and their chance. *)
let label codec (label : Catalogue.label) =
  bytes (fun b ->
      match label with
      | One l ->
        Packed.put_nat b 0;
        Label_codec.put codec b l
      | Tied (l, chance) ->
        Packed.put_nat b 0;
        Label_codec.put codec b l;
        Packed.put_rational b chance
      | Joint { chance; transitions } ->
        Packed.put_nat b transitions;
        Packed.put_rational b chance)

let of_label codec text : Catalogue.label =
  reading text (fun source ->
      match Packed.nat source with
      | 0 ->
        let label = Label_codec.read codec source in
        if Packed.at_end source then Catalogue.One label else Tied (label, Packed.rational source)
      | transitions -> Joint { chance = Packed.rational source; transitions })

let make codec =
  let codec () = Lazy.force codec in
  {
    Catalogue.process = (fun p -> bytes (fun b -> State_codec.put_process (codec ()) b p));
    of_process = (fun text -> reading text (State_codec.process (codec ())));
    label = (fun l -> label (codec ()) l);
    of_label = (fun text -> of_label (codec ()) text);
    step = (fun s -> bytes (fun b -> State_codec.put_step b s));
    of_step = (fun text -> reading text State_codec.step);
    time = (fun t -> bytes (fun b -> Packed.put_rational b t));
    of_time = (fun text -> reading text Packed.rational);
  }
