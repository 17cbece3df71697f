//! Before anything is timed: do all contestants make the same shader of the same graph?
//!
//! Each must validate and offer the same interface; on the smaller graphs, whose loops a software GPU compiles in seconds, each
//! must compute the same values, bit for bit.

use super::gpu::{Lab, Program};
use crate::Outcome;
use crate::graph::{Plan, Settings};
use crate::tool::{Session, Tool};

/// How many values are compared.
const VALUES: u64 = 4096;
const WORKGROUP: u32 = 64;
/// Software GPUs compile every call anew: larger graphs would take minutes.
const MOST_FUNCTIONS: usize = 64;

/// Fails where two of `tools` do not agree on `plan`. Whether values were compared, too.
pub(crate) fn hold(lab: &Lab, plan: Plan, tools: &[Tool]) -> Outcome<bool> {
    let compares = plan.modules * plan.functions <= MOST_FUNCTIONS;
    for settings in [Settings::default(), Settings { fine: false, gain: 73 }] {
        let mut first: Option<(Tool, String, Vec<f32>)> = None;
        for tool in tools {
            let graph = plan.graph(tool.dialect());
            let composed = Session::open(*tool, &graph)?.compose(settings)?;
            let interface = interface(composed.module());
            let values = if compares { values(lab, &composed.wgsl()?)? } else { Vec::new() };
            let Some((other, expected, numbers)) = &first else {
                first = Some((*tool, interface, values));
                continue;
            };
            let of = |what| {
                format!("{}: {} and {} have not the same {what}", plan.name(), other.name(), tool.name())
            };
            if interface != *expected {
                return Err(format!("{}:\n{expected}\n{interface}", of("interface")).into());
            }
            if values.iter().map(|value| value.to_bits()).ne(numbers.iter().map(|value| value.to_bits())) {
                return Err(of("values").into());
            }
        }
    }
    Ok(compares)
}

/// Entry points and bindings, a line each.
fn interface(module: &naga::Module) -> String {
    let entries = module.entry_points.iter().map(|entry| {
        let arguments = entry.function.arguments.iter().map(|argument| format!("{:?}", argument.binding));
        let arguments = arguments.collect::<Vec<_>>().join(", ");
        format!("{:?} {} {:?} ({arguments})", entry.stage, entry.name, entry.workgroup_size)
    });
    let bindings = module.global_variables.iter().filter_map(|(_, variable)| {
        let size = module.types[variable.ty].inner.size(module.to_ctx());
        Some(format!(
            "{:?} {:?} {} {size} bytes",
            variable.binding?,
            variable.space,
            variable.name.as_deref()?
        ))
    });
    let mut lines: Vec<String> = entries.chain(bindings).collect();
    lines.sort();
    lines.join("\n")
}

fn values(lab: &Lab, wgsl: &str) -> Outcome<Vec<f32>> {
    let program = Program::new(lab, wgsl, VALUES)?;
    program.run((VALUES / u64::from(WORKGROUP)) as u32)?;
    let values = program.values()?;
    let is_varied = values.windows(2).any(|pair| pair[0] != pair[1]);
    if is_varied { Ok(values) } else { Err("all values are the same: nothing was computed".into()) }
}
