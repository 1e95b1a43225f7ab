use super::execute::Studies;

/// Every point of every study, a line each.
pub fn table(studies: &Studies) -> String {
    let mut text = String::from(
        "scene,body,method,setting,error_rad,reference_doubt_rad,evaluations,steps,rejections,\
         cost_median_s,cost_lower_quartile_s,cost_upper_quartile_s,repeats,on_front,picked_by_auto\n",
    );
    for (scene, bodies) in studies {
        for study in bodies {
            for point in &study.points {
                let cells = [
                    scene.clone(),
                    study.body.clone(),
                    point.method.key().to_owned(),
                    point.value.map_or_else(String::new, |value| format!("{value:e}")),
                    format!("{:e}", point.error_rad),
                    format!("{:e}", study.reference.doubt_rad),
                    point.effort.evaluations.to_string(),
                    point.effort.steps.to_string(),
                    point.effort.rejections.to_string(),
                    format!("{:e}", point.cost.median_s),
                    format!("{:e}", point.cost.lower_s),
                    format!("{:e}", point.cost.upper_s),
                    point.cost.count.to_string(),
                    point.is_on_front.to_string(),
                    (study.auto == Some(point.method)).to_string(),
                ];
                text.push_str(&cells.join(","));
                text.push('\n');
            }
        }
    }
    text
}
